// SPDX-License-Identifier: Apache-2.0
#include "experiment/sweep/five_numbers.hpp"

#include <algorithm>

namespace caravan::experiment {
namespace {

/// @pre the sample is sorted and not empty. `quarters` out of 4.
double quantile(const std::vector<double>& sorted, std::size_t quarters) {
  const std::size_t scaled = quarters * (sorted.size() - 1);
  const std::size_t below = scaled / 4;
  const double part = static_cast<double>(scaled % 4) / 4.0;
  const double low = sorted[below];
  return part == 0.0 ? low : low + part * (sorted[below + 1] - low);
}

}  // namespace

std::optional<FiveNumbers> five_numbers(std::vector<double> sample) {
  if (sample.empty()) return std::nullopt;
  std::ranges::sort(sample);
  return FiveNumbers{.n = sample.size(),
                     .minimum = sample.front(),
                     .lower_quartile = quantile(sample, 1),
                     .median = quantile(sample, 2),
                     .upper_quartile = quantile(sample, 3),
                     .maximum = sample.back()};
}

}  // namespace caravan::experiment
