// SPDX-License-Identifier: Apache-2.0
#include "world_server/starts/starts.hpp"

#include <algorithm>
#include <map>
#include <numbers>
#include <optional>

#include "runtime/config/start_error.hpp"
#include "runtime/pure/random.hpp"
#include "world_server/shapes/scene.hpp"

namespace caravan::world {
namespace {

constexpr std::uint64_t kStream = 0x5741525453;  // stream of random numbers; an arbitrary constant
constexpr int kTries = 300;                      // per place in an area before the area grows
constexpr double kGrowth = 1.0;                  // m on each side
constexpr double kLattice = 0.1;
constexpr double kMostSteps = 5000.0;  // of the lattice along the arena: a larger arena has wider steps
constexpr double kClearance = 0.05;    // m between a body in any orientation and anything solid

/// Free ground, and the robots placed on it so far.
class Ground {
 public:
  explicit Ground(const WorldConfig& config)
      : spacing_{config.start_spacing_m},
        reach_{body_radius_m(config.robots) + kClearance},
        low_{reach_ - 0.5 * config.arena_m[0], reach_ - 0.5 * config.arena_m[1]},
        high_{-low_.x, -low_.y} {
    for (const Box& box : config.boxes) solids_.push_back(to_solid(box));
    for (const Cylinder& cylinder : config.cylinders) solids_.push_back(to_solid(cylinder));
    for (const Outline& outline : config.outlines) solids_.push_back(to_solid(outline));
  }

  [[nodiscard]] bool is_free(Point place) const {
    if (place.x < low_.x || place.y < low_.y || place.x > high_.x || place.y > high_.y) return false;
    const auto [row, column] = cell_of(place);
    for (long y = row - 1; y <= row + 1; ++y) {
      for (auto at = taken_.lower_bound({y, column - 1});
           at != taken_.end() && at->first <= Cell{y, column + 1}; ++at) {
        if (length(at->second - place) < spacing_) return false;
      }
    }
    return std::all_of(solids_.begin(), solids_.end(),
                       [&](const Solid& solid) { return distance_to(solid, place) >= reach_; });
  }
  void take(Point place) { taken_.emplace(cell_of(place), place); }

  /// The first free place on the lattice, searched from the lower left.
  [[nodiscard]] std::optional<Point> search() const {
    const double step = std::max(kLattice, std::max(high_.x - low_.x, high_.y - low_.y) / kMostSteps);
    const auto across = [step](double from, int steps) { return from + steps * step; };
    for (int row = 0; across(low_.y, row) <= high_.y; ++row) {
      for (int column = 0; across(low_.x, column) <= high_.x; ++column) {
        const Point place{across(low_.x, column), across(low_.y, row)};
        if (is_free(place)) return place;
      }
    }
    return std::nullopt;
  }
  [[nodiscard]] bool is_covered_by(const Extent& area) const {
    return area.low.x <= low_.x && area.low.y <= low_.y && area.high.x >= high_.x && area.high.y >= high_.y;
  }
  [[nodiscard]] Extent clipped(const Extent& area) const {
    return {{std::max(area.low.x, low_.x), std::max(area.low.y, low_.y)},
            {std::min(area.high.x, high_.x), std::min(area.high.y, high_.y)}};
  }

 private:
  using Cell = std::pair<long, long>;  // row, column
  [[nodiscard]] Cell cell_of(Point place) const {
    return {std::lround(std::floor(place.y / spacing_)), std::lround(std::floor(place.x / spacing_))};
  }

  double spacing_;
  double reach_;
  Point low_;  // of the places whose surroundings are within the walls
  Point high_;
  std::vector<Solid> solids_;
  std::multimap<Cell, Point> taken_;
};

std::optional<Point> try_area(const Ground& ground, const Extent& area, pure::Random& random) {
  for (int i = 0; i < kTries; ++i) {
    const double x = random.uniform(area.low.x, area.high.x);
    const double y = random.uniform(area.low.y, area.high.y);
    if (ground.is_free({x, y})) return Point{x, y};
  }
  return std::nullopt;
}

}  // namespace

std::vector<Pose> choose_starts(const WorldConfig& config) {
  pure::Random random{config.seed, kStream};
  Ground ground{config};
  Extent area{to_point(config.start_low_m), to_point(config.start_high_m)};
  std::vector<Pose> starts;
  while (starts.size() < config.robots.count) {
    std::optional<Point> place = try_area(ground, area, random);
    if (!place && !ground.is_covered_by(area)) {
      area = ground.clipped({area.low - Point{kGrowth, kGrowth}, area.high + Point{kGrowth, kGrowth}});
      continue;
    }
    if (!place) place = ground.search();
    if (!place) {
      throw runtime::StartError{"robots.count: the arena is full with " + std::to_string(starts.size()) +
                                " robots; " + std::to_string(config.robots.count) +
                                " are requested: enlarge world.arena_m or use fewer"};
    }
    ground.take(*place);
    starts.push_back({place->x, place->y, random.uniform(-std::numbers::pi, std::numbers::pi)});
  }
  return starts;
}

}  // namespace caravan::world
