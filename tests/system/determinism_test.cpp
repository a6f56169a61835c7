// SPDX-License-Identifier: Apache-2.0
// One scenario gives one digest, whatever the engine, the transport, the number of processes, the repetition
// and the load of the machine. The slow cases are in determinism_long_test.cpp.
#include <gmock/gmock.h>

#include <filesystem>

#include "build_paths.hpp"
#include "tests/system/support/burners.hpp"
#include "tests/system/support/digest_of.hpp"

namespace caravan::test {
namespace {

/// The small scenario, long enough for paths to be found and exchanged.
const std::vector<std::string> kExperiment{"--mode", "full", "--items", "0", "--max-time", "150"};

class Determinism : public testing::TestWithParam<Placement> {};

TEST_P(Determinism, GivesTheEmbeddedEnginesDigest) {
  const std::string expected = digest_of("small.toml", kEmbedded, kExperiment);
  for (int repetition = 0; repetition < GetParam().repetitions; ++repetition) {
    SCOPED_TRACE(repetition);
    EXPECT_EQ(digest_of("small.toml", GetParam().options, kExperiment), expected);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Placements, Determinism,
    testing::Values(Placement{"Embedded", kEmbedded, 2}, Placement{"AProcessEach", {}, 2},
                    Placement{"TwoInAProcess", {"--agents-per-process", "2"}, 1},
                    Placement{"ThreeInAProcess", {"--agents-per-process", "3"}, 1},
                    Placement{"AllInOneProcess", {"--agents-per-process", "4"}, 1},
                    Placement{"Udp", {"--transport", "udp"}, 1},
                    Placement{"UdpAllInOneProcess", {"--transport", "udp", "--agents-per-process", "4"}, 1}),
    name_of_placement);

/// A controller from outside, whose runs depend on every input.
const std::vector<std::string> kOutside{
    "--items",      "0",
    "--max-time",   "60",
    "--controller", std::filesystem::path{CARAVAN_BIN_DIR}.parent_path() / "tests/controllers/chatterer.so"};

class DeterminismOfAController : public Determinism {};

TEST_P(DeterminismOfAController, GivesTheEmbeddedEnginesDigest) {
  const std::string expected = digest_of("small.toml", kEmbedded, kOutside);
  EXPECT_NE(expected, digest_of("small.toml", kEmbedded, {"--items", "0", "--max-time", "60"}));
  for (int repetition = 0; repetition < GetParam().repetitions; ++repetition)
    EXPECT_EQ(digest_of("small.toml", GetParam().options, kOutside), expected);
}

INSTANTIATE_TEST_SUITE_P(
    Placements, DeterminismOfAController,
    testing::Values(Placement{"Embedded", kEmbedded, 2}, Placement{"AProcessEach", {}, 2},
                    Placement{"UdpAllInOneProcess", {"--transport", "udp", "--agents-per-process", "4"}, 1}),
    name_of_placement);

TEST(ControllerDeterminism, HoldsOnABusyMachine) {
  const std::string expected = digest_of("small.toml", kEmbedded, kOutside);
  const Burners burners;
  EXPECT_EQ(digest_of("small.toml", {}, kOutside), expected);
}

TEST(Determinism, HoldsOnABusyMachine) {
  const std::vector<std::string> experiment{"--mode", "full", "--items", "0", "--max-time", "40"};
  const std::string expected = digest_of("small.toml", kEmbedded, experiment);
  const Burners burners;
  EXPECT_EQ(digest_of("small.toml", {}, experiment), expected);
}

TEST(Determinism, AnotherSeedGivesAnotherDigest) {
  const std::vector<std::string> experiment{"--items", "0", "--max-time", "10"};
  std::vector<std::string> another = experiment;
  another.insert(another.end(), {"--seed", "2"});
  EXPECT_NE(digest_of("small.toml", kEmbedded, experiment), digest_of("small.toml", kEmbedded, another));
}

}  // namespace
}  // namespace caravan::test
