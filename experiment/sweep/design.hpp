// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/config/setting.hpp"

namespace caravan::experiment {

/// A key that differs between the runs of a sweep.
struct Axis {
  std::string key;
  std::string place;  ///< precedes `key=value` in errors: `--set `, `plan.toml:4: `
};

/// The points of a sweep: each a value for every axis. Without axes, one point.
struct Design {
  std::vector<Axis> axes;
  std::vector<std::vector<std::string>> points = {{}};  ///< different ones; values as in runtime::Setting
};

/// An axis and what it can be.
struct Factor {
  Axis axis;
  std::vector<std::string> values = {};  ///< different ones; empty: a range
  double low = 0.0;
  double high = 0.0;      ///< >= low
  bool whole = false;     ///< the range is of whole numbers, both ends included
  std::string base = {};  ///< for one_at_a_time()
};

/// Most points of a design; more are taken for a typing error.
inline constexpr std::size_t kMostPoints = 100'000;

/// Every combination of the factors' values; the last factor varies fastest.
/// @throws runtime::StartError for more than kMostPoints, or a key that two factors have
[[nodiscard]] Design full_factorial(std::span<const Factor> factors);

/// The base values of all factors; then, factor by factor, each of its other values, with the base values of
/// the other factors.
/// @throws runtime::StartError as full_factorial()
[[nodiscard]] Design one_at_a_time(std::span<const Factor> factors);

/// A Latin hypercube (McKay, Beckman, Conover 1979): each factor's range, or list of values, is cut into
/// `points` equal parts, and each part is used once, at a random place in it, in a random order. Points that
/// are equal, as whole numbers can be, appear once.
///
/// The same arguments give the same design on every machine.
/// @throws runtime::StartError as full_factorial()
[[nodiscard]] Design latin_hypercube(std::span<const Factor> factors, std::size_t points, std::uint64_t seed);

/// These points, in this order; equal ones appear once.
/// @pre each point has a value for each axis
/// @throws runtime::StartError as full_factorial()
[[nodiscard]] Design explicit_points(std::vector<Axis> axes, std::vector<std::vector<std::string>> points);

/// Each point of `one` with each of `other`; those of `other` vary fastest.
/// @throws runtime::StartError as full_factorial()
[[nodiscard]] Design crossed(const Design& one, const Design& other);

/// The changes of the scenario at a point.
[[nodiscard]] runtime::Settings settings_at(const Design& design, std::size_t point);

/// A name of a folder for a point: `algorithm.vision_radius_m=2,robots.count=5`. Long values, and those with
/// letters that do not belong into such a name, are shortened to a hash. Empty without axes. Points of the
/// same axes have different names.
[[nodiscard]] std::string folder_of(const Design& design, std::size_t point);

}  // namespace caravan::experiment
