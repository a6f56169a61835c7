// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/routes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "runtime/pure/assert.hpp"

namespace caravan::experiment {
namespace {

constexpr double kSameRoute_m = 3.0;
constexpr double kSpacing_m = 0.25;
constexpr double kMostPieces = 4000.0;  // of one path: 1 km at this spacing

double distance_m(const Place& a, const Place& b) { return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m); }

std::size_t root_of(std::vector<std::size_t>& parents, std::size_t one) {
  while (parents[one] != one) one = parents[one] = parents[parents[one]];
  return one;
}

}  // namespace

double path_length_m(std::span<const Place> path) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) length_m += distance_m(path[i - 1], path[i]);
  return length_m;
}

std::vector<Place> resample(std::span<const Place> path, double spacing_m) {
  CARAVAN_ASSERT(!path.empty() && spacing_m > 0.0);
  const double length_m = path_length_m(path);
  const auto pieces = static_cast<std::size_t>(std::ceil(length_m / spacing_m));
  std::vector<Place> result{path.front()};
  std::size_t segment = 1;
  double before_m = 0.0;  // length up to the first vertex of `segment`
  for (std::size_t i = 1; i < pieces; ++i) {
    const double wanted_m = length_m * static_cast<double>(i) / static_cast<double>(pieces);
    double own_m = distance_m(path[segment - 1], path[segment]);
    while (before_m + own_m < wanted_m && segment + 1 < path.size()) {
      before_m += own_m;
      ++segment;
      own_m = distance_m(path[segment - 1], path[segment]);
    }
    const double part = own_m > 0.0 ? std::min(1.0, (wanted_m - before_m) / own_m) : 0.0;
    const Place& from = path[segment - 1];
    const Place& to = path[segment];
    result.push_back({from.x_m + part * (to.x_m - from.x_m), from.y_m + part * (to.y_m - from.y_m)});
  }
  if (pieces > 0) result.push_back(path.back());
  return result;
}

bool is_frechet_below(std::span<const Place> a, std::span<const Place> b, double limit_m) {
  CARAVAN_ASSERT(!a.empty() && !b.empty());
  if (distance_m(a.front(), b.front()) >= limit_m || distance_m(a.back(), b.back()) >= limit_m) return false;
  const double square_m2 = limit_m * limit_m;
  // reachable[j]: some walk reaches (row's vertex of a, b[j]) without ever being too far apart.
  std::vector<char> reachable(b.size(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    char diagonal = i == 0 ? 1 : 0;  // previous row, previous vertex of b; the walk starts at (0, 0)
    char left = 0;
    char any = 0;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const char above = reachable[j];
      char here = 0;
      if ((above | diagonal | left) != 0) {
        const double dx_m = a[i].x_m - b[j].x_m;
        const double dy_m = a[i].y_m - b[j].y_m;
        here = dx_m * dx_m + dy_m * dy_m < square_m2 ? 1 : 0;
      }
      diagonal = above;
      reachable[j] = left = here;
      any = static_cast<char>(any | here);
    }
    if (any == 0) return false;
  }
  return reachable.back() != 0;
}

std::size_t count_routes(std::span<const std::vector<Place>> paths) {
  std::vector<std::vector<Place>> fine;
  for (const auto& path : paths) {
    if (path.empty()) continue;
    fine.push_back(resample(path, std::max(kSpacing_m, path_length_m(path) / kMostPieces)));
  }
  std::vector<std::size_t> parents(fine.size());
  std::iota(parents.begin(), parents.end(), std::size_t{0});
  std::size_t routes = fine.size();
  for (std::size_t i = 0; i < fine.size(); ++i) {
    for (std::size_t j = i + 1; j < fine.size(); ++j) {
      const std::size_t one = root_of(parents, i);
      const std::size_t other = root_of(parents, j);
      if (one == other || !is_frechet_below(fine[i], fine[j], kSameRoute_m)) continue;
      parents[other] = one;
      --routes;
    }
  }
  return routes;
}

}  // namespace caravan::experiment
