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

/// What metrics.json and events.csv of the run would say if it ended now: one session, as of its newest whole
/// step. For several threads at a time.
class Tally {
 public:
  using Number = std::variant<double, std::string>;

  explicit Tally(experiment::RunFacts facts);

  void observe(const experiment::Observation& observation);
  void note(const experiment::RunEnd& end);

  /// By its key in metrics.json, as in `exchanges.completed`, or by one of `per_robot` for robot > 0. none:
  /// null, or no such key.
  [[nodiscard]] std::optional<Number> metric(const std::string& key, std::uint32_t robot) const;
  /// So many events of this kind; robot 0: of all robots.
  [[nodiscard]] std::uint32_t events(const std::string& kind, std::uint32_t robot) const;
  /// The detail of the robot's newest event of this kind.
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
  mutable std::optional<experiment::Result>
      result_;  // of metrics_, when it was asked for since the newest step
  experiment::EventBook book_;
  std::map<std::pair<std::string, std::uint32_t>, Kind> events_;
};

/// The keys that metric() knows: of the run, and of each robot.
struct MetricKeys {
  std::set<std::string> of_run;
  std::set<std::string> of_robot;
};
[[nodiscard]] const MetricKeys& metric_keys();

}  // namespace caravan::deploy
