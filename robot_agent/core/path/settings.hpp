// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

#include "robot_agent/core/types.hpp"

/// What a scenario can say of paths. Keys and ranges: docs/scenario.md.
namespace caravan::agent {

/// The path that an exploring robot leaves behind it.
struct RecordingSettings {
  double spacing_m = 1.0;  ///< between vertices

  bool operator==(const RecordingSettings&) const = default;
};

/// Algorithm 4.
struct Smoothing {
  double vision_radius_m = 6.0;           ///< vertices within it are candidates
  double gain_m = 0.05;                   ///< a shortcut that saves less is not worth it
  Time pause = std::chrono::minutes{10};  ///< before a shortcut that was blocked is tried again

  bool operator==(const Smoothing&) const = default;
};

}  // namespace caravan::agent
