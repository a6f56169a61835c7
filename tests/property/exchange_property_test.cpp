// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tests/property/air_world.hpp"

namespace caravan::agent::testing {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::uint64_t kSeeds = 500;

bool has_completed(const AirWorld::Robot& robot) {
  for (const Exchange& exchange : robot.ended) {
    if (exchange.completed) return true;
  }
  return false;
}

TEST(ExchangeProperty, InQuietAirPathsOfAnyLengthCrossInFewSteps) {  // P-40
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    pure::Random random{seed};
    AirWorld world{seed, CommunicationSettings{}};
    const auto points = [&random] { return 2 + static_cast<std::size_t>(random.uniform(0.0, 300.0)); };
    world.add(3, path_of(3, points()));
    world.add(7, random.chance(0.2) ? Path{} : path_of(7, points()));
    world.run(60);
    EXPECT_EQ(world.robot(7).received.size(), 1U);
    EXPECT_EQ(world.robot(3).received.size(), world.robot(7).path.empty() ? 0U : 1U);
    const std::size_t longest = std::max(world.robot(3).path.size(), world.robot(7).path.size());
    const auto fragments = static_cast<int>((longest + 19) / 20);
    for (const auto& [id, robot] : world.robots()) {
      EXPECT_TRUE(has_completed(robot));
      EXPECT_LE(robot.stood, (fragments + 7) * AirWorld::kStep) << "robot " << id;
    }
    ASSERT_THAT(world.breaches, IsEmpty());
  }
}

TEST(ExchangeProperty, AtHalfTheFramesLostMostExchangesCompleteAndBothSidesKnow) {  // P-41
  int completed = 0;
  int known_to_one = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    AirWorld world{seed, CommunicationSettings{}};
    world.weather = {.loss = 0.5, .duplicate = 0.1, .max_delay_steps = 2};
    world.add(3, path_of(3, 45));
    world.add(7, path_of(7, 120));
    world.run_for(12s);
    const bool three = has_completed(world.robot(3));
    const bool seven = has_completed(world.robot(7));
    completed += three && seven ? 1 : 0;
    known_to_one += three != seven ? 1 : 0;
    ASSERT_THAT(world.breaches, IsEmpty());
  }
  EXPECT_GE(completed, 475) << "of " << kSeeds;
  EXPECT_LE(known_to_one, 5);
}

TEST(ExchangeProperty, SeveralPairsOnOnePrivateChannelOnlySlowEachOtherDown) {  // P-46
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    CommunicationSettings config;
    config.air.channel_count = seed % 2 == 0 ? 3 : 2;
    AirWorld world{seed, config};
    world.weather.loss = seed % 4 < 2 ? 0.0 : 0.2;
    for (std::uint16_t id = 1; id <= 8; ++id) world.add(id, path_of(id, 60));
    world.run_for(20s);
    std::size_t received = 0;
    for (const auto& [id, robot] : world.robots()) received += robot.received.size();
    EXPECT_GE(received, 40U);  // of 56 possible ones
    ASSERT_THAT(world.breaches, IsEmpty());
  }
}

TEST(ExchangeProperty, TheSmallestMtuIsEnough) {  // P-13
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    CommunicationSettings config;
    config.air.mtu_bytes = 32;
    AirWorld world{seed, config};
    world.weather.loss = seed % 2 == 0 ? 0.0 : 0.2;
    world.add(3, path_of(3, 50));
    world.add(7, path_of(7, 20));
    world.run_for(15s);
    EXPECT_THAT(world.robot(3).received, ElementsAre(path_of(7, 20)));
    EXPECT_THAT(world.robot(7).received, ElementsAre(path_of(3, 50)));
    ASSERT_THAT(world.breaches, IsEmpty());
  }
}

}  // namespace
}  // namespace caravan::agent::testing
