// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "robot_agent/core/navigation/driver.hpp"
#include "robot_agent/core/path/route.hpp"
#include "robot_agent/core/task/gripper.hpp"
#include "robot_agent/core/task/notes.hpp"
#include "robot_agent/core/task/settings.hpp"

namespace caravan::agent {

struct CarrierSettings {
  Task task;
  Progress progress;
  PathFollowing following;
  Smoothing smoothing;
  RecordingSettings recording;
  Exploration exploration;
  Passage passage;
  ObstacleMemory obstacles;
  Body body;
};

/// A robot with a path: Algorithm 1, lines 12 and 13. It carries items along its path and shortens the path.
///
///   state     | path free     | obstacle, touch           | no progress | wandered far enough
///   ----------+---------------+---------------------------+-------------+--------------------
///   Following | drive, smooth | shortcut provisional: old | Wandering   | -
///             |               | section back; else round  |             |
///   Wandering | explore       | new location              | -           | Following
///
/// A touch counts only while no robot is near; without a provisional shortcut the driver's own manoeuvre is
/// enough. Wandering also ends after Progress::wander_timeout, and at an end of the path.
class Carrier {
 public:
  /// Starts at `p_WB` and drives to the source first: the drive that found the destination delivers nothing.
  /// @param path driven, from the source to the destination
  Carrier(const CarrierSettings& settings, Path path, const Point& p_WB);

  [[nodiscard]] Motion step(const Perception& seen, Driver& driver, pure::Random& random, Notes& notes);
  /// Updates the gripper from Perception::holding. Call in every step with a position, also while the robot
  /// stands.
  void sense(const Perception& seen, Notes& notes);
  /// Adopts another path with the same ends.
  void adopt(Path path, const Point& p_WB);

  [[nodiscard]] const Path& path() const { return route_.driven(); }
  [[nodiscard]] bool towards_destination() const { return route_.towards_destination(); }
  [[nodiscard]] bool gripper_closed() const { return gripper_.closed(); }
  [[nodiscard]] std::uint32_t trips() const { return trips_; }

 private:
  struct Following {};
  struct Wandering {
    Point began_at;
    double enough_m = 0.0;
    Time give_up{0};
    std::optional<Point> location;
  };
  [[nodiscard]] Motion follow(const Perception& seen, Driver& driver, pure::Random& random, Notes& notes);
  [[nodiscard]] Motion wander(Wandering& state, const Perception& seen, Driver& driver, pure::Random& random);
  void arrive(const Perception& seen, Notes& notes);
  void smooth(const Perception& seen);
  void react(Obstruction obstruction, const Perception& seen, Driver& driver, pure::Random& random,
             Notes& notes);
  [[nodiscard]] bool makes_progress(const Perception& seen);
  void expect_progress();

  CarrierSettings settings_;
  Route route_;
  Refusals refusals_;
  Gripper gripper_;
  std::variant<Following, Wandering> state_;
  std::uint32_t trips_ = 0;
  Point last_smoothed_at_;
  double best_remaining_m_;
  Time without_progress_{0};
  Time last_step_{0};
  Time last_wander_;
  std::uint32_t wanders_ = 0;
};

}  // namespace caravan::agent
