// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/result_table.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "experiment/metrics/csv_file.hpp"
#include "experiment/metrics/metric_table.hpp"
#include "runtime/pure/assert.hpp"

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
      text += facts.items == 0 ? "ran for its full time" : "all items delivered";
      break;
    case Outcome::kTimeOver:
      text += "time limit reached";
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

/// The metrics of one run by name, as readable text.
class Shown {
 public:
  explicit Shown(const RunView& run) : run_{run}, robots_{numbers_of_robots(run.result)} {}

  /// @param name  its key, or its column if it has no key. An unknown name is a bug.
  [[nodiscard]] MetricValue value(std::string_view name) const {
    const Metric* metric = find_metric(name);
    if (metric != nullptr) return metric->of_run(run_);
    const auto found = std::ranges::find(metrics_table(), name, &Metric::column);
    CARAVAN_ASSERT(found != metrics_table().end() && found->of_robots != nullptr);
    const std::optional<double> number = found->of_robots(robots_);
    return number ? MetricValue{*number} : MetricValue{};
  }

  [[nodiscard]] std::string operator()(std::string_view name, int decimals = 0) const {
    return to_text(value(name), decimals);
  }
  [[nodiscard]] std::string clock(std::string_view name) const {
    return minutes(std::get<double>(value(name)));
  }

  [[nodiscard]] static std::string to_text(const MetricValue& value, int decimals) {
    if (const auto* number = std::get_if<double>(&value)) return fixed(*number, decimals);
    if (const auto* count = std::get_if<std::uint64_t>(&value)) return std::to_string(*count);
    const auto* word = std::get_if<std::string>(&value);
    return word == nullptr ? "-" : *word;
  }

 private:
  const RunView& run_;
  std::vector<RobotNumbers> robots_;
};

std::string items_line(const Shown& shown, const RunFacts& facts) {
  const bool has_trip = std::get<double>(shown.value("round_trip_mean_s")) > 0.0;
  return "items       " + shown("items_delivered") +
         (facts.items > 0 ? " of " + std::to_string(facts.items) : std::string{}) + " in " +
         shown.clock("sim_time_s") + " simulated (" + shown("wall_time_s", 1) + " s, " +
         shown("real_time_factor", 1) + " x real time); mean round trip " +
         (has_trip ? shown.clock("round_trip_mean_s") : "-") + "\n";
}

std::string path_line(const Shown& shown, const Result& result) {
  std::vector<double> lengths_m;
  for (const RobotResult& robot : result.robots) {
    if (robot.path_length_m) lengths_m.push_back(*robot.path_length_m);
  }
  std::string text = "paths       " + shown("found") + " found, " + shown("received") + " received, " +
                     shown("without_path") + " without";
  if (!lengths_m.empty()) {
    const auto [least, most] = std::ranges::minmax_element(lengths_m);
    text += "; mean length " + shown("path_length_mean_m", 1) + " m (" + fixed(*least, 1) + " to " +
            fixed(*most, 1) + "); routes " + shown("routes");
  }
  return text + "\n";
}

std::string robots_heading() {
  std::string text;
  for (const RobotMetric& metric : robot_metrics()) text += metric.heading;
  return text + "\n";
}

std::string robot_line(const RobotResult& robot) {
  std::string text;
  for (const RobotMetric& metric : robot_metrics()) {
    const MetricValue value = metric.value(robot);
    const auto* time_s = metric.unit == "s" ? std::get_if<double>(&value) : nullptr;
    const std::string word = time_s != nullptr ? minutes(*time_s) : Shown::to_text(value, 1);
    if (!metric.heading.empty()) text += right(word, metric.heading.size());
  }
  return text + "\n";
}

}  // namespace

std::string result_table(const RunFacts& facts, const Result& result, const RunEnd& end) {
  const RunView run{facts, result, end};
  const Shown shown{run};
  std::string text = heading(facts, result, end);
  text += items_line(shown, facts);
  text += path_line(shown, result);
  text += "exchanges   " + shown("exchanges.completed") + " completed, " + shown("exchanges.failed") +
          " failed; mean duration " + shown("exchanges.mean_duration_s", 2) + " s\n";
  text += "contacts    " + shown("contacts.robot_robot") + " between robots, " +
          shown("contacts.robot_static") + " with static objects\n";
  text += "digest      " + shown("digest") + "\n";
  for (const std::string& one : end.strangers) text += "stranger    " + one + "\n";
  text += "\n" + robots_heading();
  for (const RobotResult& robot : result.robots) text += robot_line(robot);
  return text + "(times in simulated minutes:seconds)\n";
}

}  // namespace caravan::experiment
