// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/path/smoothing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "runtime/pure/assert.hpp"

namespace caravan::agent {
namespace {

// Number of candidates whose way is checked. They are tried in the order of their saving.
constexpr std::size_t kMostTried = 8;

/// The candidates that save most, best first; allocates no memory.
class BestFew {
 public:
  void offer(const Shortcut& shortcut) {
    if (count_ == kMostTried && shortcut.gain_m <= few_.back().gain_m) return;
    std::size_t at = count_ < kMostTried ? count_++ : kMostTried - 1;
    for (; at > 0 && few_[at - 1].gain_m < shortcut.gain_m; --at) few_[at] = few_[at - 1];
    few_[at] = shortcut;
  }
  [[nodiscard]] std::span<const Shortcut> all() const { return {few_.data(), count_}; }

 private:
  std::array<Shortcut, kMostTried> few_{};
  std::size_t count_ = 0;
};

}  // namespace

bool is_reachable(const Perception& seen, const Point& candidate, const Passage& passage, const Body& body) {
  const double bearing = seen.bearing_to(candidate);
  if (!seen.around.in_front_fan(bearing)) return false;
  const double distance = seen.distance_to(candidate);
  const Corridor corridor{.bearing_rad = bearing,
                          .half_width_m = 0.5 * passage.corridor_m,
                          .surface_m = passage.surface_m,
                          .surface_per_metre = passage.surface_per_metre};
  return seen.around.clearance_m(corridor) > distance + body.ahead_m;
}

std::optional<Shortcut> find_shortcut(const Ahead& ahead, const Perception& seen,
                                      const ShortcutSearch& search, const Refusals& refusals) {
  const std::size_t size = ahead.plan.size();
  if (ahead.next >= size) return std::nullopt;
  const double squared_radius = search.vision_radius_m * search.vision_radius_m;
  const double to_next = seen.distance_to(ahead.plan[ahead.next]);
  BestFew few;
  for (std::size_t i = ahead.next + 1; i < size; ++i) {
    const double squared = (ahead.plan[i] - seen.p_WB).squaredNorm();
    if (squared > squared_radius) continue;
    const double along = to_next + ahead.to_end_m[ahead.next] - ahead.to_end_m[i];
    const double gain = along - std::sqrt(squared);
    if (gain >= search.least_gain_m) few.offer({i, gain});
  }
  for (const Shortcut& shortcut : few.all()) {
    const Point& candidate = ahead.plan[shortcut.candidate];
    if (is_reachable(seen, candidate, search.passage, search.body) &&
        !refusals.refuses(seen.p_WB, candidate, seen.now)) {
      return shortcut;
    }
  }
  return std::nullopt;
}

Shortened with_shortcut(const Ahead& ahead, const Point& at, std::size_t candidate, double spacing_m,
                        double merge_m) {
  CARAVAN_ASSERT(ahead.next <= candidate && candidate < ahead.plan.size() && spacing_m > 0.0);
  Shortened result;
  Path& path = result.path;
  path.assign(ahead.plan.begin(), ahead.plan.begin() + static_cast<std::ptrdiff_t>(ahead.next));
  const Point from = on_grid(at);
  while (path.size() > 1 && (path.back() - from).norm() < merge_m) path.pop_back();
  if (path.empty() || path.back() != from) path.push_back(from);
  result.next = path.size();
  const Point to = ahead.plan[candidate];
  const double distance = (to - from).norm();
  const auto pieces = std::max<std::int64_t>(1, std::llround(distance / spacing_m));
  for (std::int64_t piece = 1; piece < pieces; ++piece) {
    const double part = static_cast<double>(piece) / static_cast<double>(pieces);
    path.push_back(on_grid(from + part * (to - from)));
  }
  result.last = path.size();
  path.insert(path.end(), ahead.plan.begin() + static_cast<std::ptrdiff_t>(candidate), ahead.plan.end());
  return result;
}

}  // namespace caravan::agent
