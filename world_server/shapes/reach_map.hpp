// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "world_server/shapes/scene.hpp"

namespace caravan::world {

/// For each square metre of the arena (or a millionth of the arena, if that is larger) the static things
/// within reach of it, computed once.
class ReachMap {
 public:
  /// @param things  extents of the things to find
  /// @param reach   metres, >= 0
  ReachMap(const std::array<double, 2>& arena_m, std::span<const Extent> things, double reach);

  /// Indices of all things within reach of `place`, and some others; ascending. For a place outside the
  /// arena, those of the nearest place inside.
  [[nodiscard]] std::span<const std::uint32_t> near(Point place) const;

 private:
  [[nodiscard]] std::size_t column(double x) const;
  [[nodiscard]] std::size_t row(double y) const;

  double cell_;  // side length
  Point low_;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<std::uint32_t> first_;  // by cell: where its things begin; one more at the end
  std::vector<std::uint32_t> things_;
};

}  // namespace caravan::world
