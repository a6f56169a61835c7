// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "experiment/metrics/metrics.hpp"
#include "experiment/metrics/run_facts.hpp"

/// The only table of metrics. It defines metrics.json, the result table, the columns of a sweep, the queries
/// of the test kit and the tables of docs/outputs.md.
namespace caravan::experiment {

/// A run that has ended, or as it would be if it ended now.
struct RunView {
  const RunFacts& facts;
  const Result& result;
  const RunEnd& end;
  bool ended = true;
};

/// std::monostate: no value, null in metrics.json.
using MetricValue =
    std::variant<std::monostate, bool, std::uint64_t, double, std::string, std::vector<std::string>>;

/// The numbers of one robot by key; none: null. Their source is a Result or a metrics.json.
using RobotNumbers = std::function<std::optional<double>(std::string_view key)>;

/// The subject of a metric.
enum class About : std::uint8_t {
  kSetUp,   ///< known before the run
  kEnding,  ///< how the run ended
  kResult
};

/// One metric of a run. It has exactly one of the two functions, except the row `per_robot`, which has none:
/// robot_metrics() replaces it.
struct Metric {
  std::string_view key =
      {};  ///< in metrics.json; `exchanges.completed` is within `exchanges`; empty: not there
  std::string_view column = {};  ///< of a sweep's tables; empty: not there
  std::string_view unit = {};    ///< s or m; empty: a count, a word, yes or no
  std::string_view meaning = {};
  MetricValue (*of_run)(const RunView&) = nullptr;
  std::optional<double> (*of_robots)(std::span<const RobotNumbers>) = nullptr;
  About about = About::kResult;
  bool repeats = true;  ///< false: wall time, which is not repeatable
};
/// Whether its values are yes or no; 1 and 0 in a column.
[[nodiscard]] bool is_yes_or_no(const Metric& metric);
/// In the order of metrics.json and of the columns.
[[nodiscard]] std::span<const Metric> metrics_table();
/// @return null when metrics.json has no single value with this key
[[nodiscard]] const Metric* find_metric(std::string_view key);

/// One metric of each robot.
struct RobotMetric {
  std::string_view key = {};   ///< in the entries of `per_robot`
  std::string_view unit = {};  ///< s or m; empty: a count
  std::string_view meaning = {};
  MetricValue (*value)(const RobotResult&) = nullptr;
  std::string_view heading = {};  ///< in the result table, right-aligned; empty: not there
};
/// In the order of metrics.json and of the result table.
[[nodiscard]] std::span<const RobotMetric> robot_metrics();
/// @return null when no metric has this key
[[nodiscard]] const RobotMetric* find_robot_metric(std::string_view key);

/// The numbers of a result's robots. `result` must outlive them.
[[nodiscard]] std::vector<RobotNumbers> numbers_of_robots(const Result& result);

}  // namespace caravan::experiment
