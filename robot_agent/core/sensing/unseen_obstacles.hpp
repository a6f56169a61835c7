// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/sensing/perception.hpp"
#include "robot_agent/core/sensing/surfaces.hpp"
#include "robot_agent/core/sensing/touch.hpp"
#include "robot_agent/core/sensing/touched_places.hpp"
#include "robot_agent/core/sensing/vanishing_echo.hpp"

namespace caravan::agent {

struct ObstacleSettings {
  ObstacleMemory memory{};
  TouchSensing touch{};
  EchoLoss echo{};
  PatienceSettings patience{};
  Body body{};
  double vision_radius_m = 6.0;  ///< obstacles within it are reported for planning
};

/// Obstacles that the sonars do not see from close by. They are detected by the wheels, or by an echo that
/// vanishes, remembered for the whole run, and added to the surroundings for planning and driving.
///
/// A touch does not count when a robot is at that place, when a robot of unknown position is received, or
/// when the sonars saw something there from close by: the corner of something high. Places where they do so
/// later are forgotten. A robot without progress for PatienceSettings::timeout forgets the places around it:
/// wrong ones hold it no longer than that.
class UnseenObstacles {
 public:
  explicit UnseenObstacles(const ObstacleSettings& settings)
      : settings_{settings},
        sensor_{settings.touch},
        vanishing_{settings.echo},
        places_{settings.memory},
        patience_{settings.patience} {}

  /// Call in every step; completes `seen`.
  /// @param told  wheel speeds commanded in the previous step
  /// @return a new place, frame W
  std::optional<Point> feel(const Sensors& sensors, const Wheels& told, const Surfaces& surfaces,
                            Perception& seen);
  /// Adds a place in front of the robot, which drove forward without moving. @return the place if it is new,
  /// frame W
  std::optional<Point> touch_ahead(const Surfaces& surfaces, const Perception& seen);

 private:
  [[nodiscard]] bool is_explained(const Touch& touch, const Surfaces& surfaces, const Perception& seen) const;
  [[nodiscard]] std::optional<Point> expect(const Surfaces& surfaces, const Perception& seen);
  ObstacleSettings settings_;
  TouchSensor sensor_;
  VanishingEcho vanishing_;
  TouchedPlaces places_;
  Patience patience_;
};

}  // namespace caravan::agent
