// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "world_server/shapes/point.hpp"

namespace caravan::world {

/// Finds the points near a place among many moving points.
class Neighbours {
 public:
  /// @param points  a point with a NaN is never found
  /// @param reach   metres, > 0
  void rebuild(std::span<const Point> points, double reach);

  /// Indices of the points within reach of `place`, ascending; replaces the content of `found`.
  void near(Point place, std::vector<std::uint32_t>& found) const;

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;  // row, column
  [[nodiscard]] Cell cell_of(Point place) const;

  double reach_ = 1.0;
  std::vector<Point> points_;
  std::vector<std::pair<Cell, std::uint32_t>> cells_;  // sorted
};

}  // namespace caravan::world
