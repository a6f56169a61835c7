// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "experiment/metrics/event_book.hpp"
#include "experiment/metrics/metrics.hpp"
#include "experiment/metrics/run_facts.hpp"

namespace caravan::deploy {

/// The content of metrics.json and events.csv if the run ended now: one session, as of its latest complete
/// step. Thread-safe.
class Tally {
 public:
  using Number = std::variant<double, std::string>;

  explicit Tally(experiment::RunFacts facts);

  void observe(const experiment::Observation& observation);
  void note(const experiment::RunEnd& end);

  /// A value by its key in metrics.json, such as `exchanges.completed`, or in `per_robot` for robot > 0.
  /// none: null, or no such key.
  [[nodiscard]] std::optional<Number> metric(const std::string& key, std::uint32_t robot) const;
  /// Number of events of this kind; robot 0: of all robots.
  [[nodiscard]] std::uint32_t events(const std::string& kind, std::uint32_t robot) const;
  /// The detail of the robot's latest event of this kind.
  [[nodiscard]] std::optional<std::string> detail(const std::string& kind, std::uint32_t robot) const;

 private:
  struct Kind {
    std::uint32_t count = 0;
    std::string newest;
  };
  mutable std::mutex mutex_;
  experiment::RunFacts facts_;
  experiment::RunEnd end_;
  experiment::Metrics metrics_;
  mutable std::optional<experiment::Result> result_;  // of metrics_, if computed since the latest step
  experiment::EventBook book_;
  std::map<std::pair<std::string, std::uint32_t>, Kind> events_;
};

/// The keys of metric(): of the run, and of each robot.
struct MetricKeys {
  std::set<std::string> of_run;
  std::set<std::string> of_robot;
};
[[nodiscard]] const MetricKeys& metric_keys();

}  // namespace caravan::deploy
