// SPDX-License-Identifier: Apache-2.0
// The assertions of determinism_test.cpp with many repetitions and on the paper's experiment. For tests/run
// --long.
#include <gmock/gmock.h>

#include "tests/system/support/burners.hpp"
#include "tests/system/support/digest_of.hpp"

namespace caravan::test {
namespace {

/// Long enough for exchanges of paths, which begin after 15 min.
const std::vector<std::string> kFirstTwentyMinutes{"--items", "0", "--max-time", "1200"};

class SmallDeterminism : public testing::TestWithParam<Placement> {};

TEST_P(SmallDeterminism, GivesTheEmbeddedEnginesDigestEveryTime) {
  const std::vector<std::string> experiment{"--items", "0", "--max-time", "300"};
  const std::string expected = digest_of("small.toml", kEmbedded, experiment);
  for (int repetition = 0; repetition < GetParam().repetitions; ++repetition) {
    SCOPED_TRACE(repetition);
    ASSERT_EQ(digest_of("small.toml", GetParam().options, experiment), expected);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Placements, SmallDeterminism,
    testing::Values(Placement{"Embedded", kEmbedded, 10}, Placement{"AProcessEach", {}, 10},
                    Placement{"TwoInAProcess", {"--agents-per-process", "2"}, 10},
                    Placement{"AllInOneProcess", {"--agents-per-process", "4"}, 10},
                    Placement{"Udp", {"--transport", "udp"}, 10},
                    Placement{"UdpAllInOneProcess", {"--transport", "udp", "--agents-per-process", "4"}, 10}),
    name_of_placement);

class PaperDeterminism : public testing::TestWithParam<Placement> {};

TEST_P(PaperDeterminism, GivesTheEmbeddedEnginesDigestEveryTime) {
  const std::string expected = digest_of("paper.toml", kEmbedded, kFirstTwentyMinutes);
  for (int repetition = 0; repetition < GetParam().repetitions; ++repetition) {
    SCOPED_TRACE(repetition);
    ASSERT_EQ(digest_of("paper.toml", GetParam().options, kFirstTwentyMinutes), expected);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Placements, PaperDeterminism,
    testing::Values(Placement{"Embedded", kEmbedded, 10}, Placement{"AProcessEach", {}, 10},
                    Placement{"TwoInAProcess", {"--agents-per-process", "2"}, 1},
                    Placement{"AllInOneProcess", {"--agents-per-process", "15"}, 1},
                    Placement{"Udp", {"--transport", "udp"}, 1},
                    Placement{"UdpAllInOneProcess", {"--transport", "udp", "--agents-per-process", "15"}, 1}),
    name_of_placement);

TEST(PaperDeterminismLong, HoldsOnABusyMachine) {
  const std::vector<std::string> experiment{"--items", "0", "--max-time", "100"};
  const std::string expected = digest_of("paper.toml", kEmbedded, experiment);
  const Burners burners;
  EXPECT_EQ(digest_of("paper.toml", {}, experiment), expected);
}

TEST(PaperDeterminismLong, HoldsToTheLastDelivery) {
  EXPECT_EQ(digest_of("paper.toml", {}, {}), digest_of("paper.toml", kEmbedded, {}));
}

}  // namespace
}  // namespace caravan::test
