// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/metric_table.hpp"

#include <algorithm>
#include <array>

namespace caravan::experiment {
namespace {

using Robots = std::span<const RobotNumbers>;

MetricValue or_null(const std::optional<Time>& time) {
  return time ? MetricValue{in_seconds(*time)} : MetricValue{};
}

double real_time_factor(const RunView& run) {
  return run.end.wall_time_s > 0.0 ? in_seconds(run.result.sim_time) / run.end.wall_time_s : 0.0;
}

bool is_completed(const RunView& run) {
  return outcome_of(run.facts, run.end, run.result.items_delivered, run.result.sim_time) ==
         Outcome::kCompleted;
}

/// Number of robots that have a value for `key`.
double count_with(Robots robots, std::string_view key) {
  return static_cast<double>(
      std::ranges::count_if(robots, [key](const RobotNumbers& one) { return one(key).has_value(); }));
}

double sum_of(Robots robots, std::string_view key) {
  double sum = 0.0;
  for (const RobotNumbers& one : robots) sum += one(key).value_or(0.0);
  return sum;
}

std::optional<double> mean_of(Robots robots, std::string_view key) {
  const double count = count_with(robots, key);
  return count > 0.0 ? std::optional{sum_of(robots, key) / count} : std::nullopt;
}

double most_of(Robots robots, std::string_view key) {
  double most = 0.0;
  for (const RobotNumbers& one : robots) most = std::max(most, one(key).value_or(0.0));
  return most;
}

double without_path(Robots robots) {
  return static_cast<double>(std::ranges::count_if(
      robots, [](const RobotNumbers& one) { return !one("found_s") && !one("received_s"); }));
}

// One row per metric: key, column, unit and meaning, then the value.
// clang-format off
const std::array kMetrics{
    Metric{.key = "scenario", .meaning = "key `name` of the scenario; without it, the name of its file",
           .of_run = [](const RunView& run) -> MetricValue { return run.facts.scenario; }, .about = About::kSetUp},
    Metric{.key = "engine", .meaning = "`dds` or `embedded`",
           .of_run = [](const RunView& run) -> MetricValue { return run.facts.engine; }, .about = About::kSetUp},
    Metric{.key = "controller", .meaning = "`paper`, or the name that the controller's library gives itself",
           .of_run = [](const RunView& run) -> MetricValue { return run.facts.controller; }, .about = About::kSetUp},
    Metric{.key = "mode", .meaning = "`none`, `partial` or `full`",
           .of_run = [](const RunView& run) -> MetricValue { return run.facts.mode; }, .about = About::kSetUp},
    Metric{.key = "seed", .meaning = "seed of the scenario",
           .of_run = [](const RunView& run) -> MetricValue { return run.facts.seed; }, .about = About::kSetUp},
    Metric{.key = "robots", .meaning = "number of robots",
           .of_run = [](const RunView& run) -> MetricValue { return std::uint64_t{run.facts.robots}; }, .about = About::kSetUp},
    Metric{.key = "ended",
           .meaning = "false: an interim state; the program was killed before the run ended",
           .of_run = [](const RunView& run) -> MetricValue { return run.ended; }, .about = About::kEnding},
    Metric{.key = "completed", .column = "completed",
           .meaning = "all items were delivered; with `experiment.items = 0`: the run lasted its full time",
           .of_run = [](const RunView& run) -> MetricValue { return is_completed(run); }},
    Metric{.key = "disturbed", .column = "disturbed",
           .meaning = "a process was lost or rejoined (the digest is then not comparable), or the run was steered (`caravan ctl`)",
           .of_run = [](const RunView& run) -> MetricValue { return run.end.disturbed; }},
    Metric{.key = "interrupted", .meaning = "stopped by a signal",
           .of_run = [](const RunView& run) -> MetricValue { return run.end.interrupted; }, .about = About::kEnding},
    Metric{.key = "failure", .meaning = "why the run ended early; empty if it did not",
           .of_run = [](const RunView& run) -> MetricValue { return run.end.failure; }, .about = About::kEnding},
    Metric{.key = "items_delivered", .column = "items_delivered", .meaning = "total number of items delivered",
           .of_run = [](const RunView& run) -> MetricValue { return std::uint64_t{run.result.items_delivered}; }},
    Metric{.key = "sim_time_s", .column = "sim_time_s", .unit = "s", .meaning = "simulated time",
           .of_run = [](const RunView& run) -> MetricValue { return in_seconds(run.result.sim_time); }},
    Metric{.key = "wall_time_s", .column = "wall_time_s", .unit = "s", .meaning = "wall time from the first step to the last",
           .of_run = [](const RunView& run) -> MetricValue { return run.end.wall_time_s; }, .repeats = false},
    Metric{.key = "real_time_factor", .column = "real_time_factor", .meaning = "simulated time divided by wall time",
           .of_run = [](const RunView& run) -> MetricValue { return real_time_factor(run); }, .repeats = false},
    Metric{.key = "digest",
           .meaning = "16 hexadecimal digits over all commands, poses, transmissions and deliveries up to the deciding step; equal digests = "
                      "equal runs ([digest.md](digest.md))",
           .of_run = [](const RunView& run) -> MetricValue { return run.end.digest; }},
    Metric{.key = "round_trip_mean_s", .column = "round_trip_mean_s", .unit = "s",
           .meaning = "mean over all robots' times from a pick-up to the same robot's next; 0: no robot picked up twice",
           .of_run = [](const RunView& run) -> MetricValue { return run.result.round_trip_mean_s; }},
    Metric{.key = "routes", .column = "routes",
           .meaning = "groups of paths in use at the end. Two paths are on one route when their discrete Frechet distance, resampled to "
                      "0.25 m (beyond 1 km, to 4000 pieces), is below 3 m, or when a chain of such paths connects them",
           .of_run = [](const RunView& run) -> MetricValue { return std::uint64_t{run.result.routes}; }},
    Metric{.column = "found", .meaning = "robots that found their first path themselves",
           .of_robots = [](Robots robots) -> std::optional<double> { return count_with(robots, "found_s"); }},
    Metric{.column = "received", .meaning = "robots that got their first path from another robot",
           .of_robots = [](Robots robots) -> std::optional<double> { return count_with(robots, "received_s"); }},
    Metric{.column = "without_path", .meaning = "robots that never had a path",
           .of_robots = [](Robots robots) -> std::optional<double> { return without_path(robots); }},
    Metric{.column = "path_length_mean_m", .unit = "m",
           .meaning = "mean over the robots with a path in use at the end; empty when there is none",
           .of_robots = [](Robots robots) { return mean_of(robots, "path_length_m"); }},
    Metric{.key = "exchanges.completed", .column = "exchanges_completed",
           .meaning = "completed sessions; a session of a pair counts once, as completed if either robot reports it so",
           .of_run = [](const RunView& run) -> MetricValue { return run.result.exchanges_completed; }},
    Metric{.key = "exchanges.failed", .column = "exchanges_failed",
           .meaning = "all other sessions; an attempt that ended before its session had a number counts once for each robot that gave up",
           .of_run = [](const RunView& run) -> MetricValue { return run.result.exchanges_failed; }},
    Metric{.key = "exchanges.mean_duration_s", .column = "exchange_mean_s", .unit = "s",
           .meaning = "mean over all robots' attempts, failed ones included, of the time from stopping to resuming; 0: none",
           .of_run = [](const RunView& run) -> MetricValue { return run.result.exchange_mean_s; }},
    Metric{.key = "contacts.robot_robot", .column = "contacts_robot_robot",
           .meaning = "episodes of two robots touching, counted once per pair; a new one only after 1 s apart",
           .of_run = [](const RunView& run) -> MetricValue { return run.result.robot_robot_contacts; }},
    Metric{.key = "contacts.robot_static", .column = "contacts_robot_static",
           .meaning = "episodes of a robot touching something static; a new one only after 1 s apart",
           .of_run = [](const RunView& run) -> MetricValue { return run.result.robot_static_contacts; }},
    Metric{.column = "stuck_s", .unit = "s", .meaning = "sum of `stuck_s` over the robots",
           .of_robots = [](Robots robots) -> std::optional<double> { return sum_of(robots, "stuck_s"); }},
    Metric{.column = "longest_stuck_s", .unit = "s", .meaning = "maximum of `longest_stuck_s` over the robots",
           .of_robots = [](Robots robots) -> std::optional<double> { return most_of(robots, "longest_stuck_s"); }},
    Metric{.key = "commands.refused", .meaning = "wheel commands that were not finite",
           .of_run = [](const RunView& run) -> MetricValue { return run.end.refusals.commands_refused; }},
    Metric{.key = "commands.clamped", .meaning = "wheel commands beyond the wheel limit",
           .of_run = [](const RunView& run) -> MetricValue { return run.end.refusals.commands_clamped; }},
    Metric{.key = "frames.over_mtu", .meaning = "radio frames refused when sent: longer than the MTU",
           .of_run = [](const RunView& run) -> MetricValue { return run.end.refusals.frames_over_mtu; }},
    Metric{.key = "frames.bad_channel", .meaning = "radio frames refused when sent: no such channel",
           .of_run = [](const RunView& run) -> MetricValue { return run.end.refusals.frames_on_bad_channel; }},
    Metric{.key = "frames.lost",
           .meaning = "receptions lost by the scenario's loss probability or `caravan ctl radio`",
           .of_run = [](const RunView& run) -> MetricValue { return run.end.refusals.frames_lost; }},
    Metric{.key = "frames.queue_full",
           .meaning = "receptions lost because the receiver's limit for the step was reached",
           .of_run = [](const RunView& run) -> MetricValue { return run.end.refusals.frames_queue_full; }},
    Metric{.key = "frames.malformed", .meaning = "frames received that do not follow the protocol",
           .of_run = [](const RunView& run) -> MetricValue { return run.result.malformed_frames; }},
    Metric{.key = "strangers",
           .meaning = "a line for each participant of the domain whose samples were refused, or that writes to agents in place of the "
                      "world or the radio: who refused it, its identity, how many samples, on which topics "
                      "([protocol.md](protocol.md#roles)). Normally empty; strangers do not change the digest. The result table has these "
                      "lines too",
           .of_run = [](const RunView& run) -> MetricValue { return run.end.strangers; }},
    Metric{.key = "per_robot", .meaning = "an entry for each robot, sorted by `id`, see below",
           .about = About::kEnding},
    Metric{.key = "time_split.physics", .unit = "s", .meaning = "wall time of the physics",
           .of_run = [](const RunView& run) -> MetricValue { return run.end.time_split.physics_s; }, .repeats = false},
    Metric{.key = "time_split.sensors", .unit = "s", .meaning = "wall time of the sensors",
           .of_run = [](const RunView& run) -> MetricValue { return run.end.time_split.sensors_s; }, .repeats = false},
    Metric{.key = "time_split.radio", .unit = "s", .meaning = "wall time of the radio",
           .of_run = [](const RunView& run) -> MetricValue { return run.end.time_split.radio_s; }, .repeats = false},
    Metric{.key = "time_split.agents", .unit = "s", .meaning = "wall time of all agents together",
           .of_run = [](const RunView& run) -> MetricValue { return run.end.time_split.agents_s; }, .repeats = false},
    Metric{.key = "time_split.transport", .unit = "s", .meaning = "the rest of the wall time: DDS, waiting",
           .of_run = [](const RunView& run) -> MetricValue { return run.end.time_split.transport_s; }, .repeats = false},
};

const std::array kRobotMetrics{
    RobotMetric{.key = "id", .meaning = "the robot's number, from 1",
                .value = [](const RobotResult& robot) -> MetricValue { return std::uint64_t{robot.id}; }, .heading = "robot"},
    RobotMetric{.key = "found_s", .unit = "s", .meaning = "time at which it got its first path by finding the destination itself, or null",
                .value = [](const RobotResult& robot) { return or_null(robot.found); }, .heading = "    found"},
    RobotMetric{.key = "received_s", .unit = "s",
                .meaning = "time at which it got its first path from another robot, or null; at most one of the two is set",
                .value = [](const RobotResult& robot) { return or_null(robot.received); }, .heading = "  received"},
    RobotMetric{.key = "items", .meaning = "items delivered",
                .value = [](const RobotResult& robot) -> MetricValue { return std::uint64_t{robot.items}; }, .heading = "  items"},
    RobotMetric{.key = "path_length_m", .unit = "m", .meaning = "length of the path in use at the end, or null",
                .value = [](const RobotResult& robot) { return robot.path_length_m ? MetricValue{*robot.path_length_m} : MetricValue{}; },
                .heading = "  path, m"},
    RobotMetric{.key = "driving_s", .unit = "s", .meaning = "time during which it reports driving",
                .value = [](const RobotResult& robot) -> MetricValue { return in_seconds(robot.times.driving); }, .heading = "   driving"},
    RobotMetric{.key = "exchanging_s", .unit = "s", .meaning = "time during which it reports exchanging",
                .value = [](const RobotResult& robot) -> MetricValue { return in_seconds(robot.times.exchanging); },
                .heading = "  exchanging"},
    RobotMetric{.key = "avoiding_s", .unit = "s", .meaning = "time during which it reports avoiding something",
                .value = [](const RobotResult& robot) -> MetricValue { return in_seconds(robot.times.avoiding); },
                .heading = "  avoiding"},
    RobotMetric{.key = "stuck_s", .unit = "s",
                .meaning = "time without progress, whatever it reports. A window of 60 s counts as stuck, from start to end, if the robot never "
                      "got 0.5 m away from its position at the start of the window, and exchanged nothing. A window begins at each "
                      "simulated second. The five times add up to `sim_time_s`",
                .value = [](const RobotResult& robot) -> MetricValue { return in_seconds(robot.times.stuck); }, .heading = "   stuck"},
    RobotMetric{.key = "idle_s", .unit = "s", .meaning = "time during which it reports none of these; an absent robot is idle, and so is one whose controller reports nothing",
                .value = [](const RobotResult& robot) -> MetricValue { return in_seconds(robot.times.idle); }, .heading = "    idle"},
    RobotMetric{.key = "longest_stuck_s", .unit = "s",
                .meaning = "the longest uninterrupted part of `stuck_s`. In the paper's experiment, more than 300 is a failure of the algorithm; "
                           "for another controller it only says how long a robot stayed in one place",
                .value = [](const RobotResult& robot) -> MetricValue { return in_seconds(robot.times.longest_stuck); }},
};
// clang-format on

std::optional<double> to_number(const MetricValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* count = std::get_if<std::uint64_t>(&value)) return static_cast<double>(*count);
  return std::nullopt;
}

}  // namespace

std::span<const Metric> metrics_table() { return kMetrics; }
std::span<const RobotMetric> robot_metrics() { return kRobotMetrics; }

bool is_yes_or_no(const Metric& metric) {
  const RunFacts facts{};
  const Result result;
  const RunEnd end;
  return metric.of_run != nullptr && std::holds_alternative<bool>(metric.of_run({facts, result, end}));
}

const Metric* find_metric(std::string_view key) {
  const auto found = std::ranges::find(kMetrics, key, &Metric::key);
  return key.empty() || found == kMetrics.end() || found->of_run == nullptr ? nullptr : &*found;
}

const RobotMetric* find_robot_metric(std::string_view key) {
  const auto found = std::ranges::find(kRobotMetrics, key, &RobotMetric::key);
  return found == kRobotMetrics.end() ? nullptr : &*found;
}

std::vector<RobotNumbers> numbers_of_robots(const Result& result) {
  std::vector<RobotNumbers> numbers;
  for (const RobotResult& robot : result.robots) {
    numbers.emplace_back([&robot](std::string_view key) -> std::optional<double> {
      const RobotMetric* metric = find_robot_metric(key);
      return metric == nullptr ? std::nullopt : to_number(metric->value(robot));
    });
  }
  return numbers;
}

}  // namespace caravan::experiment
