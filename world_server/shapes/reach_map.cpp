// SPDX-License-Identifier: Apache-2.0
#include "world_server/shapes/reach_map.hpp"

#include <algorithm>
#include <cmath>

namespace caravan::world {
namespace {

constexpr double kSmallestCell = 1.0;
constexpr double kMostCells = 1000.0;  // along one side of the arena

/// Index of the cell, out of `count`, that is `from_low` cells from the first one's edge; the first or last
/// one if it is outside.
std::size_t cell_at(double from_low, std::size_t count) {
  const double cell = std::floor(from_low);
  return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(count - 1)));
}

}  // namespace

ReachMap::ReachMap(const std::array<double, 2>& arena_m, std::span<const Extent> things, double reach)
    : cell_{std::max(kSmallestCell, std::max(arena_m[0], arena_m[1]) / kMostCells)},
      low_{-0.5 * arena_m[0], -0.5 * arena_m[1]},
      columns_{static_cast<std::size_t>(std::ceil(arena_m[0] / cell_))},
      rows_{static_cast<std::size_t>(std::ceil(arena_m[1] / cell_))} {
  std::vector<std::vector<std::uint32_t>> cells(columns_ * rows_);
  for (std::size_t i = 0; i < things.size(); ++i) {
    const Extent& extent = things[i];
    for (std::size_t y = row(extent.low.y - reach); y <= row(extent.high.y + reach); ++y) {
      for (std::size_t x = column(extent.low.x - reach); x <= column(extent.high.x + reach); ++x) {
        cells[y * columns_ + x].push_back(static_cast<std::uint32_t>(i));
      }
    }
  }
  for (const auto& cell : cells) {
    first_.push_back(static_cast<std::uint32_t>(things_.size()));
    things_.insert(things_.end(), cell.begin(), cell.end());
  }
  first_.push_back(static_cast<std::uint32_t>(things_.size()));
}

std::size_t ReachMap::column(double x) const { return cell_at((x - low_.x) / cell_, columns_); }
std::size_t ReachMap::row(double y) const { return cell_at((y - low_.y) / cell_, rows_); }

std::span<const std::uint32_t> ReachMap::near(Point place) const {
  const std::size_t cell = row(place.y) * columns_ + column(place.x);
  return std::span{things_}.subspan(first_[cell], first_[cell + 1] - first_[cell]);
}

}  // namespace caravan::world
