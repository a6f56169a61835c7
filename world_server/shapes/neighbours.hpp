// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "world_server/shapes/point.hpp"

namespace caravan::world {

/// Which of many moving points are near a place.
class Neighbours {
 public:
  /// @param points  one with a NaN is nowhere
  /// @param reach   metres, > 0
  void rebuild(std::span<const Point> points, double reach);

  /// Indices of the points within reach of `place`, ascending; replaces what `found` held.
  void near(Point place, std::vector<std::uint32_t>& found) const;

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;  // row, column
  [[nodiscard]] Cell cell_of(Point place) const;

  double reach_ = 1.0;
  std::vector<Point> points_;
  std::vector<std::pair<Cell, std::uint32_t>> cells_;  // sorted
};

}  // namespace caravan::world
