// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace caravan::experiment {

/// The numbers of a sample's box plot.
struct FiveNumbers {
  std::size_t n = 0;
  double minimum = 0.0;
  double lower_quartile = 0.0;
  double median = 0.0;
  double upper_quartile = 0.0;
  double maximum = 0.0;
};

/// Quartiles are interpolated linearly between the sorted values: the quantile p is at position p (n - 1),
/// counted from 0 (type 7 of Hyndman and Fan, Sample Quantiles in Statistical Packages, The American
/// Statistician 50, 1996; the default of NumPy and R).
///
/// @return none for an empty sample
[[nodiscard]] std::optional<FiveNumbers> five_numbers(std::vector<double> sample);

}  // namespace caravan::experiment
