// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

/// The static things of a world as described in a scenario. All stand on the floor.
namespace caravan::world {

/// A solid box, turned about its centre.
struct Box {
  std::array<double, 2> centre_m{};
  std::array<double, 2> size_m{1.0, 1.0};
  double yaw_rad = 0.0;
  double height_m = 1.0;
};

struct Cylinder {
  std::array<double, 2> centre_m{};
  double radius_m = 0.5;
  double height_m = 1.0;
};

/// A simple polygon, possibly concave; vertices in either orientation.
struct Outline {
  std::vector<std::array<double, 2>> points_m;
  double height_m = 1.0;
};

}  // namespace caravan::world
