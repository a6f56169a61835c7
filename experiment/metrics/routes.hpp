// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "experiment/metrics/observation.hpp"

namespace caravan::experiment {

/// Sum of the lengths of the segments, metres.
[[nodiscard]] double path_length_m(std::span<const Place> path);

/// The same line with vertices at equal distances of at most `spacing_m`, its ends kept. A path without
/// length becomes one vertex.
/// @pre at least one vertex, spacing_m > 0
[[nodiscard]] std::vector<Place> resample(std::span<const Place> path, double spacing_m);

/// True iff the discrete Frechet distance (Eiter and Mannila 1994) of the two vertex sequences is below
/// `limit_m`: both can be walked forwards, vertex by vertex, and never be that far apart.
/// @pre at least one vertex each
[[nodiscard]] bool is_frechet_below(std::span<const Place> a, std::span<const Place> b, double limit_m);

/// Into how many routes the paths fall. Two paths are on the same route when they are closer than 3 m in
/// discrete Frechet distance (resampled to 0.25 m), or when a chain of such paths joins them. Empty paths are
/// no route.
[[nodiscard]] std::size_t count_routes(std::span<const std::vector<Place>> paths);

}  // namespace caravan::experiment
