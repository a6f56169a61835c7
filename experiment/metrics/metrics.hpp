// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "experiment/metrics/activity_account.hpp"
#include "experiment/metrics/exchange_account.hpp"
#include "experiment/metrics/observation.hpp"
#include "experiment/metrics/trip_book.hpp"

namespace caravan::experiment {

/// The results of a run for one robot.
struct RobotResult {
  std::uint32_t id = 0;
  std::optional<Time> found;     ///< it found its first path itself
  std::optional<Time> received;  ///< it got its first path from another robot; at most one of the two is set
  std::uint32_t items = 0;       ///< delivered
  std::optional<double> path_length_m;  ///< of the path in use
  ActivityTimes times;
};

/// The results of a run. docs/outputs.md defines each number.
struct Result {
  Time sim_time{0};
  std::uint32_t items_delivered = 0;
  double round_trip_mean_s = 0.0;  ///< 0 when no robot picked up twice
  std::size_t routes = 0;
  std::uint64_t exchanges_completed = 0;
  std::uint64_t exchanges_failed = 0;
  double exchange_mean_s = 0.0;  ///< 0 when there were no exchanges
  std::uint64_t robot_robot_contacts = 0;
  std::uint64_t robot_static_contacts = 0;
  std::uint64_t malformed_frames = 0;
  std::vector<RobotResult> robots{};  ///< sorted by id
};

/// Content of a progress line; cheap to compute at any time.
struct Progress {
  Time stamp{0};
  std::uint32_t items_delivered = 0;
  std::uint32_t robots_with_path = 0;
  std::uint64_t exchanges_completed = 0;
  std::uint64_t exchanges_failed = 0;
};

/// Computes the results of a run from its observations, step by step.
class Metrics {
 public:
  /// Robots are numbered 1 .. robots.
  explicit Metrics(std::uint32_t robots);

  /// @pre stamps never decrease. Unknown ids are ignored.
  void observe(const Observation& observation);

  /// The result as of the last observation.
  [[nodiscard]] Result result() const;
  [[nodiscard]] Progress progress() const;
  /// The paths in use; [0] is robot 1, empty: none.
  [[nodiscard]] const std::vector<std::vector<Place>>& paths() const { return paths_; }

 private:
  struct Robot {
    Place place;
    Mode mode = Mode::kExplore;
    Activity activity = Activity::kIdle;
    bool present = false;
    std::optional<Time> found;
    std::optional<Time> received;
    std::uint32_t items = 0;
    std::uint64_t malformed_frames = 0;
    ActivityAccount account;
  };
  [[nodiscard]] Robot* find(std::uint32_t robot);
  void book_time_until(Time stamp);
  void count_step(const Observation& observation);
  void take(const AgentReport& report);

  std::vector<Robot> robots_;
  std::vector<std::vector<Place>> paths_;
  Time now_{0};
  std::uint32_t items_delivered_ = 0;
  std::uint64_t robot_robot_contacts_ = 0;
  std::uint64_t robot_static_contacts_ = 0;
  ExchangeAccount exchanges_;
  TripBook trips_;
  Time round_trips_{0};
  std::uint64_t round_trip_count_ = 0;
};

}  // namespace caravan::experiment
