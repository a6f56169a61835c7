// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "experiment/metrics/observation.hpp"

namespace caravan::experiment {

/// Sum of the lengths of the segments, metres.
[[nodiscard]] double path_length_m(std::span<const Place> path);

/// The same line with vertices at equal distances of at most `spacing_m`, with the same ends. A path without
/// length becomes one vertex.
/// @pre at least one vertex, spacing_m > 0
[[nodiscard]] std::vector<Place> resample(std::span<const Place> path, double spacing_m);

/// True iff the discrete Frechet distance (Eiter and Mannila 1994) of the two vertex sequences is below
/// `limit_m`: both can be traversed forwards, vertex by vertex, without ever being that far apart.
/// @pre at least one vertex each
[[nodiscard]] bool is_frechet_below(std::span<const Place> a, std::span<const Place> b, double limit_m);

/// Number of routes of the paths. Two paths are on the same route when they are closer than 3 m in discrete
/// Frechet distance (resampled to 0.25 m; a path of more than 1 km, to 4000 pieces), or when a chain of such
/// paths connects them. Empty paths do not count.
/// @pre all places are finite
[[nodiscard]] std::size_t count_routes(std::span<const std::vector<Place>> paths);

}  // namespace caravan::experiment
