// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/result_table.hpp"

#include <algorithm>
#include <numeric>

#include "experiment/metrics/csv_file.hpp"

namespace caravan::experiment {
namespace {

std::string right(const std::string& text, std::size_t width) {
  return std::string(width > text.size() ? width - text.size() : 0, ' ') + text;
}

/// 75:08 = 75 minutes and 8 seconds.
std::string minutes(Time time) {
  const auto whole = std::chrono::round<std::chrono::seconds>(time).count();
  const std::string rest = std::to_string(whole % 60);
  return std::to_string(whole / 60) + (rest.size() < 2 ? ":0" : ":") + rest;
}

std::string minutes(double time_s) {
  return minutes(std::chrono::duration_cast<Time>(std::chrono::duration<double>{time_s}));
}

std::string heading(const RunFacts& facts, const Result& result, const RunEnd& end) {
  std::string text = facts.scenario + "  mode " + facts.mode + "  seed " + std::to_string(facts.seed) +
                     "  engine " + facts.engine + ": ";
  switch (outcome_of(facts, end, result.items_delivered, result.sim_time)) {
    case Outcome::kCompleted:
      text += facts.items == 0 ? "the time was run" : "all items delivered";
      break;
    case Outcome::kTimeOver:
      text += "the time ran out";
      break;
    case Outcome::kInterrupted:
      text += "interrupted";
      break;
    case Outcome::kFailed:
      text += "failed: " + end.failure;
      break;
  }
  return text + (end.disturbed ? " (disturbed)" : "") + "\n";
}

std::string path_line(const Result& result) {
  std::vector<double> lengths_m;
  std::size_t found = 0;
  std::size_t received = 0;
  for (const RobotResult& robot : result.robots) {
    found += robot.found ? 1U : 0U;
    received += robot.received ? 1U : 0U;
    if (robot.path_length_m) lengths_m.push_back(*robot.path_length_m);
  }
  std::string text = "paths       " + std::to_string(found) + " found, " + std::to_string(received) +
                     " received, " + std::to_string(result.robots.size() - found - received) + " without";
  if (!lengths_m.empty()) {
    const auto [least, most] = std::minmax_element(lengths_m.begin(), lengths_m.end());
    const double sum_m = std::accumulate(lengths_m.begin(), lengths_m.end(), 0.0);
    text += "; mean length " + fixed(sum_m / static_cast<double>(lengths_m.size()), 1) + " m (" +
            fixed(*least, 1) + " to " + fixed(*most, 1) + "); routes " + std::to_string(result.routes);
  }
  return text + "\n";
}

std::string robot_line(const RobotResult& robot) {
  const auto time_or_dash = [](const std::optional<Time>& time) {
    return time ? minutes(*time) : std::string{"-"};
  };
  return right(std::to_string(robot.id), 5) + right(time_or_dash(robot.found), 9) +
         right(time_or_dash(robot.received), 10) + right(std::to_string(robot.items), 7) +
         right(robot.path_length_m ? fixed(*robot.path_length_m, 1) : "-", 9) +
         right(minutes(robot.times.driving), 10) + right(minutes(robot.times.exchanging), 12) +
         right(minutes(robot.times.avoiding), 10) + right(minutes(robot.times.stuck), 8) +
         right(minutes(robot.times.idle), 8) + "\n";
}

}  // namespace

std::string result_table(const RunFacts& facts, const Result& result, const RunEnd& end) {
  const double speed = end.wall_time_s > 0.0 ? in_seconds(result.sim_time) / end.wall_time_s : 0.0;
  std::string text = heading(facts, result, end);
  text += "items       " + std::to_string(result.items_delivered);
  if (facts.items > 0) text += " of " + std::to_string(facts.items);
  text += " in " + minutes(result.sim_time) + " simulated (" + fixed(end.wall_time_s, 1) + " s, " +
          fixed(speed, 1) + " x real time); mean round trip " +
          (result.round_trip_mean_s > 0.0 ? minutes(result.round_trip_mean_s) : std::string{"-"}) + "\n";
  text += path_line(result);
  text += "exchanges   " + std::to_string(result.exchanges_completed) + " completed, " +
          std::to_string(result.exchanges_failed) + " failed; mean duration " +
          fixed(result.exchange_mean_s, 2) + " s\n";
  text += "contacts    " + std::to_string(result.robot_robot_contacts) + " robot with robot, " +
          std::to_string(result.robot_static_contacts) + " robot with something static\n";
  text += "digest      " + end.digest + "\n";
  for (const std::string& one : end.strangers) text += "stranger    " + one + "\n";
  text += "\n";
  text += "robot    found  received  items  path, m   driving  exchanging  avoiding   stuck    idle\n";
  for (const RobotResult& robot : result.robots) text += robot_line(robot);
  return text + "(times in simulated minutes:seconds)\n";
}

}  // namespace caravan::experiment
