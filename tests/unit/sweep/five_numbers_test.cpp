// SPDX-License-Identifier: Apache-2.0
#include "experiment/sweep/five_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

namespace caravan::experiment {
namespace {

std::array<double, 5> in_order(const FiveNumbers& five) {
  return {five.minimum, five.lower_quartile, five.median, five.upper_quartile, five.maximum};
}

// The expected values are those of NumPy's percentile() and R's quantile(), both with their defaults.
TEST(FiveNumbers, InterpolateLinearlyBetweenTheSortedValues) {
  EXPECT_EQ(in_order(*five_numbers({4, 1, 3, 2})), (std::array{1.0, 1.75, 2.5, 3.25, 4.0}));
  EXPECT_EQ(in_order(*five_numbers({5, 1, 4, 2, 3})), (std::array{1.0, 2.0, 3.0, 4.0, 5.0}));
  EXPECT_EQ(in_order(*five_numbers({10, 20})), (std::array{10.0, 12.5, 15.0, 17.5, 20.0}));
  EXPECT_EQ(in_order(*five_numbers({1, 2, 4, 8, 16, 32})), (std::array{1.0, 2.5, 6.0, 14.0, 32.0}));
}

TEST(FiveNumbers, OfOneValueAreThatValueAndOfNoneNothing) {
  EXPECT_EQ(in_order(*five_numbers({7})), (std::array{7.0, 7.0, 7.0, 7.0, 7.0}));
  EXPECT_EQ(five_numbers({7})->n, 1U);
  EXPECT_FALSE(five_numbers({}).has_value());
}

TEST(FiveNumbers, OfAnySampleAreSortedAndDoNotDependOnItsOrder) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random{seed};
    std::vector<double> sample(1 + random() % 40);
    for (double& value : sample) value = static_cast<double>(random() % 1000) / 10.0;
    const auto first = in_order(*five_numbers(sample));
    std::shuffle(sample.begin(), sample.end(), random);

    EXPECT_EQ(in_order(*five_numbers(sample)), first);
    EXPECT_TRUE(std::is_sorted(first.begin(), first.end()));
    EXPECT_EQ(first.front(), *std::min_element(sample.begin(), sample.end()));
    EXPECT_EQ(first.back(), *std::max_element(sample.begin(), sample.end()));
  }
}

}  // namespace
}  // namespace caravan::experiment
