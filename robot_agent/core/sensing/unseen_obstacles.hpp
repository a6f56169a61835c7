// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/sensing/perception.hpp"
#include "robot_agent/core/sensing/surfaces.hpp"
#include "robot_agent/core/sensing/touch.hpp"
#include "robot_agent/core/sensing/touched_places.hpp"
#include "robot_agent/core/sensing/vanishing_echo.hpp"

namespace caravan::agent {

/// What UnseenObstacles go by.
struct ObstacleSettings {
  ObstacleMemory memory{};
  TouchSensing touch{};
  EchoLoss echo{};
  PatienceSettings patience{};
  Body body{};
  double vision_radius_m = 6.0;  ///< what lies within it is planned round
};

/// Obstacles that the sonars do not see from close by: felt by the wheels, or noticed by an echo that
/// vanishes, remembered for the whole run, and put beside the echoes for everything that drives and plans.
///
/// What is touched is no such obstacle when a robot is there, when one is heard that does not tell where it
/// is, or when the sonars saw something there from close by: the corner of something high. Where they do so
/// later, the place is forgotten. A robot that gets nowhere for PatienceSettings::timeout forgets
/// what it touched around it: places that are wrong cannot hold it for longer.
class UnseenObstacles {
 public:
  explicit UnseenObstacles(const ObstacleSettings& settings)
      : settings_{settings},
        sensor_{settings.touch},
        vanishing_{settings.echo},
        places_{settings.memory},
        patience_{settings.patience} {}

  /// To be called in every step; completes `seen`.
  /// @param told  what the wheels were told in the step before
  /// @return the place that is new, frame W
  std::optional<Point> feel(const Sensors& sensors, const Wheels& told, const Surfaces& surfaces,
                            Perception& seen);
  /// The robot drove forward and came no further. @return the place that is new, frame W
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
