// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/sensing/surface_map.hpp"

#include <cmath>

namespace caravan::agent {
namespace {

// Bounds the memory: the walls of a large hall have fewer places.
constexpr std::size_t kMost = 20000;

bool within(const Point& a, const Point& b, double distance_m) {
  return (a - b).squaredNorm() < distance_m * distance_m;
}

}  // namespace

double SurfaceMap::square_of(double along_m) const { return std::floor(along_m / memory_.cell_m); }

template <typename Visit>
void SurfaceMap::visit_within(const Point& p_W, double radius_m, const Visit& visit) const {
  const double last = square_of(p_W.x() + radius_m);
  const double high = square_of(p_W.y() + radius_m);
  for (double x = square_of(p_W.x() - radius_m); x <= last; x += 1.0) {
    auto one = places_.lower_bound({x, square_of(p_W.y() - radius_m)});
    for (; one != places_.end() && one->first.first == x && one->first.second <= high; ++one) {
      if (within(one->second.at, p_W, radius_m)) visit(one->first, one->second);
    }
  }
}

void SurfaceMap::see(const Point& at_W, double range_m, Time now) {
  remember(at_W, now, range_m < memory_.high_range_m);
}

void SurfaceMap::touch(const Point& at_W, Time now) { remember(at_W, now, false); }

void SurfaceMap::remember(const Point& at_W, Time now, bool close) {
  if (places_.size() >= kMost) places_.clear();
  Place& place = places_[{square_of(at_W.x()), square_of(at_W.y())}];
  place = {at_W, now, place.close || close};
}

void SurfaceMap::forget_around(const Point& p_W, double radius_m) {
  std::vector<Square> gone;
  visit_within(p_W, radius_m, [&](const Square& square, const Place&) { gone.push_back(square); });
  for (const Square& square : gone) places_.erase(square);
}

bool SurfaceMap::is_high(const Point& at_W) const {
  bool high = false;
  visit_within(at_W, memory_.high_radius_m,
               [&](const Square&, const Place& place) { high = high || place.close; });
  return high;
}

void SurfaceMap::add_near(const Point& p_WB, const Span& seen, std::vector<Point>& places) const {
  if (seen.from >= seen.to) return;
  visit_within(p_WB, memory_.reach_m, [&](const Square&, const Place& place) {
    if (place.seen >= seen.from && place.seen < seen.to) places.push_back(place.at);
  });
}

}  // namespace caravan::agent
