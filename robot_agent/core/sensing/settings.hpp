// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>

#include "robot_agent/core/types.hpp"

/// What a scenario can say of the agent's senses and memory. Keys and ranges: docs/scenario.md.
namespace caravan::agent {

/// All sonars are alike.
struct Sonars {
  double aperture_rad = robot_model::kSonarAperture_rad;  ///< full cone of each
  double range_m = robot_model::kSonarRange_m;

  bool operator==(const Sonars&) const = default;
};

/// The strip that must be free of echoes on the way to a point.
struct Passage {
  double corridor_m = 0.6;  ///< full width

  bool operator==(const Passage&) const = default;
};

/// Surfaces that the sonars saw, or the robot touched.
struct SurfaceMemory {
  Time duration = std::chrono::seconds{300};  ///< kept clear of for so long; at least 20 s

  bool operator==(const SurfaceMemory&) const = default;
};

/// Obstacles that the sonars do not see from close by.
struct ObstacleMemory {
  double margin_m = 0.35;      ///< half the size that one is taken to have
  std::uint32_t places = 128;  ///< so many are remembered, for the whole run; 0: none

  bool operator==(const ObstacleMemory&) const = default;
};

/// A robot that gets nowhere forgets what it remembers around it.
struct PatienceSettings {
  Time timeout = std::chrono::seconds{15};

  bool operator==(const PatienceSettings&) const = default;
};

}  // namespace caravan::agent
