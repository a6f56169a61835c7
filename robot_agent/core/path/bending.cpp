// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/path/bending.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot_agent/core/angle.hpp"
#include "runtime/pure/assert.hpp"

namespace caravan::agent {
namespace {

constexpr double kTolerated_m = 0.05;                   // geometric: a path on the circle is not bent again
constexpr int kMostRounds = 3;                          // bounds the time: circles may overlap
constexpr double kPiece_rad = 0.25 * std::numbers::pi;  // the bend is part of an octagon

struct Crossing {
  std::size_t segment = 0;
  Point at{0.0, 0.0};
};

/// The point where the segment from `a` to `b` enters the circle (`in`), or leaves it.
std::optional<Point> crosses(const Point& a, const Point& b, const Point& centre, double radius_m, bool in) {
  const Point along = b - a;
  const double squared = along.squaredNorm();
  const double half = (a - centre).dot(along);
  const double rest = half * half - squared * ((a - centre).squaredNorm() - radius_m * radius_m);
  if (squared <= 0.0 || rest <= 0.0) return std::nullopt;
  const double t = (-half + (in ? -std::sqrt(rest) : std::sqrt(rest))) / squared;
  if (t < 0.0 || t > 1.0) return std::nullopt;
  return a + t * along;
}

std::optional<Crossing> find_crossing(const Path& path, std::size_t from, const Point& centre,
                                      double radius_m, bool in) {
  for (std::size_t i = from; i + 1 < path.size(); ++i) {
    if (const auto at = crosses(path[i], path[i + 1], centre, radius_m, in)) return Crossing{i, *at};
  }
  return std::nullopt;
}

/// The polygon around the circle between two points on it, both included.
Path polygon(const Point& centre, double radius_m, const Point& from, const Point& to) {
  const double begin = angle_of(from - centre);
  const double turn = wrapped(angle_of(to - centre) - begin);
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / kPiece_rad)));
  const double piece = turn / pieces;
  Path result{on_grid(from)};
  for (int i = 0; i < pieces; ++i) {
    const Point along = direction(begin + (i + 0.5) * piece);
    result.push_back(on_grid(centre + (radius_m / std::cos(0.5 * piece)) * along));
  }
  result.push_back(on_grid(to));
  return result;
}

/// Bends the path round one place. @return true when it was in the way
bool bend(Bend& bend, std::size_t from, const Point& place, double clear_m) {
  Path& path = bend.path;
  std::size_t after = from;
  while (after + 1 < path.size()) {
    const auto in = find_crossing(path, after, place, clear_m, true);
    if (!in) return false;
    const auto out = find_crossing(path, in->segment, place, clear_m, false);
    if (!out) return false;
    Path inside(path.begin() + static_cast<std::ptrdiff_t>(in->segment),
                path.begin() + static_cast<std::ptrdiff_t>(out->segment + 2));
    if (project(inside, place).distance_m > clear_m - kTolerated_m) {
      after = out->segment + 1;
      continue;
    }
    const Path round = polygon(place, clear_m, in->at, out->at);
    const auto gap = path.begin() + static_cast<std::ptrdiff_t>(in->segment + 1);
    const auto end = path.begin() + static_cast<std::ptrdiff_t>(out->segment + 1);
    const std::size_t removed = out->segment - in->segment;
    path.insert(path.erase(gap, end), round.begin(), round.end());
    const std::size_t last = in->segment + round.size() + 1;
    if (bend.last > out->segment) bend.last = bend.last + round.size() - removed;
    bend.last = std::max(bend.last, last);
    bend.first = std::min(bend.first, in->segment);
    return true;
  }
  return false;
}

}  // namespace

std::optional<Bend> bent_round(const Path& path, std::size_t from, std::span<const Point> places,
                               double clear_m) {
  CARAVAN_ASSERT(path.size() >= 2 && from + 1 < path.size() && clear_m > 0.0);
  Bend result{path, path.size(), 0};
  for (int round = 0; round < kMostRounds; ++round) {
    bool changed = false;
    for (const Point& place : places) changed = bend(result, from, place, clear_m) || changed;
    if (!changed) break;
  }
  if (result.last == 0) return std::nullopt;
  return result;
}

}  // namespace caravan::agent
