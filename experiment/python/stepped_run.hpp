// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "experiment/embedded/engine.hpp"
#include "experiment/metrics/event_book.hpp"
#include "experiment/metrics/metrics.hpp"

namespace caravan::experiment {

/// A run of the embedded engine that is stepped from outside, with its records in memory.
class SteppedRun {
 public:
  /// @throws runtime::StartError
  SteppedRun(const runtime::TomlDocument& scenario, agent::Controllers controllers);

  /// One step. @pre !engine().finished()
  /// @throws runtime::ControllerFault, world::PhysicsError: each later call throws a ControllerFault with the
  /// same message
  void step();

  [[nodiscard]] const Engine& engine() const { return engine_; }
  [[nodiscard]] std::uint32_t robots() const { return facts_.robots; }
  /// After the last step; [0] is robot 1.
  [[nodiscard]] const std::vector<TruePose>& poses() const { return last_.poses; }
  [[nodiscard]] std::uint32_t items_delivered() const { return last_.items_delivered; }
  /// One row for a robot in each simulated second: time_s, robot, x_m, y_m, yaw_rad.
  [[nodiscard]] const std::vector<std::array<double, 5>>& tracks() const { return tracks_; }
  [[nodiscard]] const std::vector<EventRow>& events() const { return events_; }
  /// The text of metrics.json so far.
  [[nodiscard]] std::string metrics() const;
  /// The first warning of the physics so far; empty: none.
  [[nodiscard]] const std::string& complaint() const { return complaint_; }

 private:
  void observe(const Observation& observation);

  RunFacts facts_;
  Engine engine_;
  Metrics metrics_;
  EventBook event_book_;
  std::vector<EventRow> events_;
  std::vector<std::array<double, 5>> tracks_;
  Time next_track_{0};
  double wall_time_s_ = 0.0;
  std::string failure_;
  std::string complaint_;
  Observation last_;
};

}  // namespace caravan::experiment
