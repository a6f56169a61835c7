// SPDX-License-Identifier: Apache-2.0
#include "deploy/kit/condition.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "deploy/kit/process.hpp"

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

/// Of one robot; none when the world has not shown it yet.
template <typename Read>
Quantity of_robot(Words& words, Read read) {
  return [robot = words.robot(), read](const Seen& seen) -> Value {
    const auto found = seen.robots.find(robot);
    return found == seen.robots.end() ? Value{} : read(found->second);
  };
}

/// Of what one robot says of itself; none before it has said anything.
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

/// Of a process that runs.
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

const std::array kRows{
    Row{"state",
        [](Words&) { return plain(&Seen::state); },
        {"state", "of the world: absent, waiting, running, paused or finished"}},
    Row{"step",
        [](Words&) { return plain(&Seen::step); },
        {"step", "the newest that has begun; of a paused world the next"}},
    Row{"time", [](Words&) { return plain(&Seen::time_s); }, {"time", "simulated seconds"}},
    Row{"sessions", [](Words&) { return plain(&Seen::sessions); }, {"sessions", "so many worlds were heard"}},
    Row{"items", [](Words&) { return plain(&Seen::items); }, {"items", "delivered"}},
    Row{"members", [](Words&) { return plain(&Seen::members); }, {"members", "robots in the newest step"}},
    Row{"missing",
        [](Words&) { return plain(&Seen::missing); },
        {"missing", "who has not come yet, since the start or since it was spawned, by name"}},
    Row{"hung",
        [](Words&) { return plain(&Seen::hung); },
        {"hung", "who lives but does not answer, by name"}},
    Row{"gone", [](Words&) { return plain(&Seen::gone); }, {"gone", "who was there and was lost, by name"}},
    Row{"removed",
        [](Words&) { return plain(&Seen::removed); },
        {"removed", "who was taken out of the world, by name"}},
    Row{"disturbed",
        [](Words&) { return Quantity{[](const Seen& seen) { return yes_or_no(seen.disturbed); }}; },
        {"disturbed", "yes or no"}},
    Row{"digest", [](Words&) { return plain(&Seen::digest); }, {"digest", "of the run; empty until its end"}},
    Row{"refused_commands",
        [](Words&) { return plain(&Seen::refused_commands); },
        {"refused_commands", "that were not finite"}},
    Row{"deliveries",
        [](Words&) { return plain(&Seen::deliveries); },
        {"deliveries", "frames that the radio handed over"}},
    Row{"lost_frames", [](Words&) { return plain(&Seen::lost_frames); }, {"lost_frames", "by the radio"}},
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
        {"trips ROBOT", "pick-ups so far"}},
    Row{"exchanges",
        [](Words& words) {
          return of_report(words,
                           [](const SeenRobot& one) -> Value { return static_cast<double>(one.exchanges); });
        },
        {"exchanges ROBOT", "completed ones"}},
    Row{"failed_exchanges",
        [](Words& words) {
          return of_report(
              words, [](const SeenRobot& one) -> Value { return static_cast<double>(one.failed_exchanges); });
        },
        {"failed_exchanges ROBOT", "attempts that failed"}},
    Row{"member",
        [](Words& words) {
          return of_robot(words, [](const SeenRobot& one) { return yes_or_no(one.is_member); });
        },
        {"member ROBOT", "of the newest step: yes or no"}},
    Row{"x",
        [](Words& words) { return of_robot(words, [](const SeenRobot& one) -> Value { return one.x_m; }); },
        {"x ROBOT", "metres"}},
    Row{"y",
        [](Words& words) { return of_robot(words, [](const SeenRobot& one) -> Value { return one.y_m; }); },
        {"y ROBOT", "metres"}},
    Row{"distance", read_distance, {"distance ROBOT ROBOT", "metres"}},
    Row{"process",
        read_process,
        {"process NAME", "running, suspended, ended or absent; NAME: world, radio, robot N"}},
    Row{"exit", read_exit, {"exit NAME", "the exit code; 128 + n when signal n ended it"}},
    Row{"log", read_log, {"log NAME", "what it has printed"}},
    Row{"memory",
        [](Words& words) { return of_process(words, memory_mb); },
        {"memory NAME", "MB that it has of its own or has touched of what it shares"}},
    Row{"descriptors",
        [](Words& words) { return of_process(words, descriptors); },
        {"descriptors NAME", "files and sockets that it has open"}},
};

std::string in_words(const Value& value) {
  if (!value) return "unknown";
  if (const double* number = std::get_if<double>(&*value)) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%g", *number);
    return text.data();
  }
  if (const std::string* word = std::get_if<std::string>(&*value)) {
    constexpr std::size_t kLongest = 300;
    return word->size() <= kLongest ? "\"" + *word + "\""
                                    : "\"..." + word->substr(word->size() - kLongest) + "\"";
  }
  std::string text;
  for (const std::string& name : std::get<std::vector<std::string>>(*value))
    text += (text.empty() ? "" : ", ") + name;
  return "[" + text + "]";
}

bool compare_numbers(double value, const std::string& comparison, double with) {
  if (comparison == "is") return value == with;
  if (comparison == "is not") return value != with;
  if (comparison == "<") return value < with;
  if (comparison == "<=") return value <= with;
  if (comparison == ">") return value > with;
  return comparison == ">=" && value >= with;
}

}  // namespace

std::span<const QuantityForm> quantity_forms() {
  static const std::vector<QuantityForm> forms = [] {
    std::vector<QuantityForm> made;
    for (const Row& row : kRows) made.push_back(row.form);
    return made;
  }();
  return forms;
}

Condition::Condition(const std::string& text) : text_{text} {
  Words words{split(text)};
  do {
    parts_.push_back(read_part(words));
  } while (words.take_if("and"));
  words.end();
}

Condition::Condition(std::string text, std::function<bool(const Seen&)> holds)
    : text_{std::move(text)}, holds_{std::move(holds)} {}

Condition::Part Condition::read_part(Words& words) {
  constexpr std::array<std::string_view, 7> kComparisons{"is", "<", "<=", ">", ">=", "has", "lacks"};
  const std::string name = words.word("what is expected");
  const auto row = std::find_if(kRows.begin(), kRows.end(), [&](const Row& one) { return one.name == name; });
  if (row == kRows.end()) throw WordsError{"nothing is called \"" + name + "\""};
  Part part{name, row->read(words), words.word("a comparison"), ""};
  if (std::find(kComparisons.begin(), kComparisons.end(), part.comparison) == kComparisons.end())
    throw WordsError{"\"" + part.comparison + "\" is no comparison: is, is not, <, <=, >, >=, has, lacks"};
  if (part.comparison == "is" && words.take_if("not")) part.comparison = "is not";
  part.value = words.word("the value to compare with");
  double number = 0.0;
  const auto [end, error] = std::from_chars(part.value.data(), part.value.data() + part.value.size(), number);
  const bool is_number = error == std::errc{} && end == part.value.data() + part.value.size();
  if ((part.comparison[0] == '<' || part.comparison[0] == '>') && !is_number)
    throw WordsError{"\"" + part.value + "\" is no number"};
  return part;
}

bool Condition::compare(const Value& value, const std::string& comparison, const std::string& with) {
  if (!value) return false;
  if (const double* number = std::get_if<double>(&*value)) {
    double other = 0.0;
    const auto [end, error] = std::from_chars(with.data(), with.data() + with.size(), other);
    return error == std::errc{} && end == with.data() + with.size() &&
           compare_numbers(*number, comparison, other);
  }
  if (const std::string* word = std::get_if<std::string>(&*value)) {
    if (comparison == "is") return *word == with;
    if (comparison == "is not") return *word != with;
    if (comparison == "has") return word->find(with) != std::string::npos;
    return comparison == "lacks" && word->find(with) == std::string::npos;
  }
  const auto& names = std::get<std::vector<std::string>>(*value);
  const bool has = std::find(names.begin(), names.end(), with) != names.end();
  if (comparison == "has") return has;
  if (comparison == "lacks") return !has;
  const bool equal = with == "none" ? names.empty() : names.size() == 1 && has;
  return comparison == "is" ? equal : comparison == "is not" && !equal;
}

bool Condition::holds(const Seen& seen) const {
  if (holds_) return holds_(seen);
  return std::all_of(parts_.begin(), parts_.end(), [&](const Part& part) {
    return compare(part.quantity(seen), part.comparison, part.value);
  });
}

std::string Condition::values(const Seen& seen) const {
  std::string text;
  for (const Part& part : parts_)
    text += (text.empty() ? "" : ", ") + part.name + " = " + in_words(part.quantity(seen));
  return text;
}

}  // namespace caravan::deploy
