// SPDX-License-Identifier: Apache-2.0
#include "deploy/kit/quantities.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "deploy/kit/process.hpp"
#include "deploy/kit/tally.hpp"

namespace caravan::deploy {
namespace {

struct Row {
  std::string_view name;
  Quantity (*read)(Words&);
  QuantityForm form;
};

template <typename Member>
Quantity plain(Member member) {
  return [member](const Seen& seen) -> Value {
    if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(seen.*member)>>) {
      return static_cast<double>(seen.*member);
    } else {
      return seen.*member;
    }
  };
}

Value yes_or_no(bool fact) { return std::string{fact ? "yes" : "no"}; }

/// A quantity of one robot; none before the world has published it.
template <typename Read>
Quantity of_robot(Words& words, Read read) {
  return [robot = words.robot(), read](const Seen& seen) -> Value {
    const auto found = seen.robots.find(robot);
    return found == seen.robots.end() ? Value{} : read(found->second);
  };
}

/// A quantity from a robot's report; none before its first report.
template <typename Read>
Quantity of_report(Words& words, Read read) {
  return of_robot(words,
                  [read](const SeenRobot& robot) { return robot.has_reported ? read(robot) : Value{}; });
}

Quantity read_distance(Words& words) {
  const std::uint32_t one = words.robot();
  const std::uint32_t other = words.robot();
  return [one, other](const Seen& seen) -> Value {
    const auto a = seen.robots.find(one);
    const auto b = seen.robots.find(other);
    if (a == seen.robots.end() || b == seen.robots.end()) return {};
    return std::hypot(a->second.x_m - b->second.x_m, a->second.y_m - b->second.y_m);
  };
}

std::string process_name(Words& words) {
  const std::string name = words.word("the process (world, radio or robot N)");
  return name == "robot" ? "robot " + std::to_string(words.robot()) : name;
}

Quantity read_process(Words& words) {
  return [name = process_name(words)](const Seen& seen) -> Value {
    const auto found = seen.processes.find(name);
    return found == seen.processes.end() ? std::string{"absent"} : found->second.state;
  };
}

Quantity read_exit(Words& words) {
  return [name = process_name(words)](const Seen& seen) -> Value {
    const auto found = seen.processes.find(name);
    if (found == seen.processes.end() || !found->second.exit_code) return {};
    return static_cast<double>(*found->second.exit_code);
  };
}

/// A quantity of a running process.
template <typename Read>
Quantity of_process(Words& words, Read read) {
  return [name = process_name(words), read](const Seen& seen) -> Value {
    const auto found = seen.processes.find(name);
    if (found == seen.processes.end() || found->second.exit_code) return {};
    const auto measured = read(found->second.pid);
    return measured ? Value{static_cast<double>(*measured)} : Value{};
  };
}

Quantity read_log(Words& words) {
  return [name = process_name(words)](const Seen& seen) -> Value {
    const auto found = seen.processes.find(name);
    return found == seen.processes.end() ? Value{} : read_whole_file(found->second.log);
  };
}

/// A quantity from the run's tally; none before the first world.
template <typename Read>
Quantity of_tally(Read read) {
  return [read](const Seen& seen) -> Value { return seen.tally ? read(*seen.tally) : Value{}; };
}

std::uint32_t robot_if_any(Words& words) {
  const std::string next = words.peek();
  const bool is_number = !next.empty() && next.find_first_not_of("0123456789") == std::string::npos;
  return is_number ? words.robot() : 0;
}

Quantity read_metric(Words& words) {
  const std::string key = words.word("the key, as in metrics.json");
  const bool is_of_robot = metric_keys().of_robot.contains(key);
  if (!is_of_robot && !metric_keys().of_run.contains(key))
    throw WordsError{"metrics.json has no \"" + key + "\" for use in expectations"};
  const std::uint32_t robot = is_of_robot ? words.robot() : 0;
  return of_tally([key, robot](const Tally& tally) -> Value {
    const auto metric = tally.metric(key, robot);
    if (!metric) return {};
    return std::visit([](const auto& value) -> Value { return value; }, *metric);
  });
}

std::string event_kind(Words& words) {
  std::string kind = words.word("the event, as in events.csv");
  if (kind.find_first_not_of("abcdefghijklmnopqrstuvwxyz_0123456789") != std::string::npos)
    throw WordsError{"\"" + kind + "\" is not an event name: use lower_snake_case"};
  return kind;
}

Quantity read_events(Words& words) {
  const std::string kind = event_kind(words);
  const std::uint32_t robot = robot_if_any(words);
  return of_tally(
      [kind, robot](const Tally& tally) -> Value { return static_cast<double>(tally.events(kind, robot)); });
}

Quantity read_event(Words& words) {
  const std::string kind = event_kind(words);
  const std::uint32_t robot = words.robot();
  return of_tally([kind, robot](const Tally& tally) -> Value {
    const auto detail = tally.detail(kind, robot);
    return detail ? Value{*detail} : Value{};
  });
}

const std::array kRows{
    Row{"state",
        [](Words&) { return plain(&Seen::state); },
        {"state", "state of the world: absent, waiting, running, paused or finished"}},
    Row{"step",
        [](Words&) { return plain(&Seen::step); },
        {"step", "the latest step that has started; of a paused world the next step"}},
    Row{"time", [](Words&) { return plain(&Seen::time_s); }, {"time", "simulated time, seconds"}},
    Row{"sessions",
        [](Words&) { return plain(&Seen::sessions); },
        {"sessions", "number of world sessions seen"}},
    Row{"items", [](Words&) { return plain(&Seen::items); }, {"items", "items delivered"}},
    Row{"members",
        [](Words&) { return plain(&Seen::members); },
        {"members", "number of robots in the latest step"}},
    Row{"missing",
        [](Words&) { return plain(&Seen::missing); },
        {"missing", "names of those that have not joined yet, since the start or since they were spawned"}},
    Row{"hung",
        [](Words&) { return plain(&Seen::hung); },
        {"hung", "names of those that are alive but do not answer"}},
    Row{"gone",
        [](Words&) { return plain(&Seen::gone); },
        {"gone", "names of those that had joined and were lost"}},
    Row{"removed",
        [](Words&) { return plain(&Seen::removed); },
        {"removed", "names of robots taken out of the world"}},
    Row{"disturbed",
        [](Words&) { return Quantity{[](const Seen& seen) { return yes_or_no(seen.disturbed); }}; },
        {"disturbed", "yes or no"}},
    Row{"digest",
        [](Words&) { return plain(&Seen::digest); },
        {"digest", "digest of the run; empty until its end"}},
    Row{"refused_commands",
        [](Words&) { return plain(&Seen::refused_commands); },
        {"refused_commands", "number of commands that were not finite"}},
    Row{"deliveries",
        [](Words&) { return plain(&Seen::deliveries); },
        {"deliveries", "number of frames that the radio delivered"}},
    Row{"lost_frames",
        [](Words&) { return plain(&Seen::lost_frames); },
        {"lost_frames", "number of frames that the radio lost"}},
    Row{"mode",
        [](Words& words) { return of_report(words, [](const SeenRobot& one) -> Value { return one.mode; }); },
        {"mode ROBOT", "explore or transport"}},
    Row{"activity",
        [](Words& words) {
          return of_report(words, [](const SeenRobot& one) -> Value { return one.activity; });
        },
        {"activity ROBOT", "idle, driving, avoiding or exchanging"}},
    Row{"path",
        [](Words& words) {
          return of_report(words, [](const SeenRobot& one) -> Value { return one.origin; });
        },
        {"path ROBOT", "none, found or received"}},
    Row{"trips",
        [](Words& words) {
          return of_report(words,
                           [](const SeenRobot& one) -> Value { return static_cast<double>(one.trips); });
        },
        {"trips ROBOT", "number of pick-ups so far"}},
    Row{"exchanges",
        [](Words& words) {
          return of_report(words,
                           [](const SeenRobot& one) -> Value { return static_cast<double>(one.exchanges); });
        },
        {"exchanges ROBOT", "number of completed exchanges"}},
    Row{"failed_exchanges",
        [](Words& words) {
          return of_report(
              words, [](const SeenRobot& one) -> Value { return static_cast<double>(one.failed_exchanges); });
        },
        {"failed_exchanges ROBOT", "number of failed attempts"}},
    Row{"member",
        [](Words& words) {
          return of_robot(words, [](const SeenRobot& one) { return yes_or_no(one.is_member); });
        },
        {"member ROBOT", "member of the latest step: yes or no"}},
    Row{"x",
        [](Words& words) { return of_robot(words, [](const SeenRobot& one) -> Value { return one.x_m; }); },
        {"x ROBOT", "position x, metres"}},
    Row{"y",
        [](Words& words) { return of_robot(words, [](const SeenRobot& one) -> Value { return one.y_m; }); },
        {"y ROBOT", "position y, metres"}},
    Row{"distance", read_distance, {"distance ROBOT ROBOT", "distance between two robots, metres"}},
    Row{"sends",
        [](Words& words) {
          return of_robot(
              words, [](const SeenRobot& one) -> Value { return one.sent ? Value{*one.sent} : Value{}; });
        },
        {"sends ROBOT", "the frames of its latest step, as in protocol.md: WAIT_4_BUSY ACCEPT_4-2"}},
    Row{"metric",
        read_metric,
        {"metric KEY [ROBOT]",
         "the current value of a key of metrics.json: `metric exchanges.completed`; with a robot, of a key "
         "in per_robot: `metric found_s 3`"}},
    Row{"events",
        read_events,
        {"events EVENT [ROBOT]",
         "number of rows of this event in events.csv: `events contact 3`, `events left`"}},
    Row{"event",
        read_event,
        {"event EVENT ROBOT",
         "the detail of the robot's latest event: `event exchange 3 has completed=true`"}},
    Row{"process",
        read_process,
        {"process NAME", "running, suspended, ended or absent; NAME: world, radio, robot N"}},
    Row{"exit", read_exit, {"exit NAME", "the exit code; 128 + n when signal n ended it"}},
    Row{"log", read_log, {"log NAME", "the output of the process"}},
    Row{"memory",
        [](Words& words) { return of_process(words, memory_mb); },
        {"memory NAME", "MB in use: private memory, and the shared pages it has touched"}},
    Row{"descriptors",
        [](Words& words) { return of_process(words, descriptors); },
        {"descriptors NAME", "number of open files and sockets"}},
};

}  // namespace

std::span<const QuantityForm> quantity_forms() {
  static const std::vector<QuantityForm> forms = [] {
    std::vector<QuantityForm> made;
    for (const Row& row : kRows) made.push_back(row.form);
    return made;
  }();
  return forms;
}

Quantity read_quantity(const std::string& name, Words& words) {
  const auto row = std::find_if(kRows.begin(), kRows.end(), [&](const Row& one) { return one.name == name; });
  if (row == kRows.end()) throw WordsError{"there is no quantity \"" + name + "\""};
  return row->read(words);
}

}  // namespace caravan::deploy
