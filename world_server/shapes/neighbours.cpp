// SPDX-License-Identifier: Apache-2.0
#include "world_server/shapes/neighbours.hpp"

#include <algorithm>
#include <cmath>

namespace caravan::world {

Neighbours::Cell Neighbours::cell_of(Point place) const {
  return {static_cast<std::int64_t>(std::floor(place.y / reach_)),
          static_cast<std::int64_t>(std::floor(place.x / reach_))};
}

void Neighbours::rebuild(std::span<const Point> points, double reach) {
  reach_ = reach;
  points_.assign(points.begin(), points.end());
  cells_.clear();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (std::isnan(points_[i].x) || std::isnan(points_[i].y)) continue;
    cells_.emplace_back(cell_of(points_[i]), static_cast<std::uint32_t>(i));
  }
  std::sort(cells_.begin(), cells_.end());
}

void Neighbours::near(Point place, std::vector<std::uint32_t>& found) const {
  found.clear();
  const auto [row, column] = cell_of(place);
  for (std::int64_t y = row - 1; y <= row + 1; ++y) {
    // The three cells of a row are adjacent in the sorted list.
    auto at =
        std::lower_bound(cells_.begin(), cells_.end(), std::pair{Cell{y, column - 1}, std::uint32_t{0}});
    for (; at != cells_.end() && at->first <= Cell{y, column + 1}; ++at) {
      const Point apart = points_[at->second] - place;
      if (dot(apart, apart) <= reach_ * reach_) found.push_back(at->second);
    }
  }
  std::sort(found.begin(), found.end());
}

}  // namespace caravan::world
