// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tests/property/air_world.hpp"

namespace caravan::agent::testing {
namespace {

using namespace std::chrono_literals;
using ::testing::IsEmpty;

constexpr std::uint64_t kSeeds = 500;

std::uint16_t below(pure::Random& random, int limit) {
  return static_cast<std::uint16_t>(random.uniform(0.0, limit));
}

CommunicationSettings busy_config(pure::Random& random) {
  CommunicationSettings config;
  config.sharing.mode = random.chance(0.7) ? Sharing::kFull : Sharing::kPartial;
  config.sharing.recontact_after = 3s;
  config.air.channel_count = random.chance(0.3) ? 3 : 1U << 20U;
  config.air.mtu_bytes = random.chance(0.3) ? 32 : 250;
  config.wait.period = random.chance(0.2) ? 1s : 0s;
  return config;
}

Weather bad_weather(pure::Random& random) {
  return {random.uniform(0.0, 0.5), random.uniform(0.0, 0.2), below(random, 6)};
}

/// Adds, removes, restarts, parts or rejoins robots at random.
void stir(AirWorld& world, pure::Random& random) {
  const std::uint16_t id = static_cast<std::uint16_t>(1 + below(random, 6));
  const std::uint16_t other = static_cast<std::uint16_t>(1 + below(random, 6));
  const bool is_here = world.robots().contains(id);
  const double what = random.unit();
  if (what < 0.2 && is_here) {
    world.remove(id);
  } else if (what < 0.3 && is_here) {
    world.restart(id);
  } else if (what < 0.6 && !is_here) {
    world.add(id, random.chance(0.3) ? Path{} : path_of(id, 2 + below(random, 60)));
  } else if (id != other) {
    world.part(id, other, random.chance(0.5));
  }
}

TEST(PairingProperty, WhateverHappensNobodyIsPairedWithTwoAndNobodyStandsForEver) {  // P-5, P-6
  std::size_t completed = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    pure::Random random{seed};
    AirWorld world{seed, busy_config(random)};
    world.weather = bad_weather(random);
    for (std::uint16_t id = 1; id <= 5; ++id) world.add(id, path_of(id, id == 1 ? 0 : 10U * id));
    for (int change = 0; change < 40; ++change) {
      world.run(1 + below(random, 30));
      stir(world, random);
      for (const auto& [id, robot] : world.robots()) completed += robot.out.received.has_value() ? 1 : 0;
    }
    ASSERT_THAT(world.breaches, IsEmpty());
  }
  EXPECT_GT(completed, 0U);
}

TEST(PairingProperty, PartnersAgreeSoonAfterTheAirBecomesQuiet) {  // P-7
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    pure::Random random{seed};
    CommunicationSettings config = busy_config(random);
    config.wait.period = 0s;
    AirWorld world{seed, config};
    world.weather = bad_weather(random);
    for (std::uint16_t id = 1; id <= 5; ++id) world.add(id, path_of(id, id == 1 ? 0 : 10U * id));
    world.run_for(6s);
    world.weather = {};
    world.run_for(3s);
    int asymmetric_for = 0;
    for (int step = 0; step < 150; ++step) {
      world.run(1);
      asymmetric_for = world.is_symmetric() ? 0 : asymmetric_for + 1;
      ASSERT_LE(asymmetric_for, 4) << "step " << step;
    }
    ASSERT_THAT(world.breaches, IsEmpty());
  }
}

TEST(PairingProperty, InQuietAirAllMeetAllAndThenDriveOn) {  // P-8
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    pure::Random random{seed};
    CommunicationSettings config = busy_config(random);
    config.sharing.mode = Sharing::kFull;
    config.sharing.recontact_after = 10min;
    AirWorld world{seed, config};
    world.weather = bad_weather(random);
    for (std::uint16_t id = 1; id <= 6; ++id) world.add(id, path_of(id, 5U * id));
    world.run_for(5s);
    world.weather = {};
    world.run_for(45s);  // a hold of 30 s may have to pass
    for (const auto& [id, robot] : world.robots()) {
      std::size_t met = 0;
      for (const Exchange& exchange : robot.ended) met += exchange.completed ? 1 : 0;
      EXPECT_GE(met, 4U) << "robot " << id;  // lost ENDs can postpone a partner by 10 min
      EXPECT_FALSE(robot.out.stand_still) << "robot " << id;
    }
    ASSERT_THAT(world.breaches, IsEmpty());
  }
}

TEST(PairingProperty, APartnerThatDiesAtAnyMomentCostsLittleTime) {  // P-6
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    pure::Random random{seed};
    AirWorld world{seed, CommunicationSettings{}};
    world.weather.loss = random.uniform(0.0, 0.5);
    world.add(3, path_of(3, 200));
    world.add(7, path_of(7, 200));
    world.run(below(random, 40));
    world.remove(random.chance(0.5) ? 3 : 7);
    world.run_for(10s);
    for (const auto& [id, robot] : world.robots()) {
      EXPECT_FALSE(robot.out.stand_still);
      EXPECT_LE(robot.stood, 2s + 40 * AirWorld::kStep);
    }
    ASSERT_THAT(world.breaches, IsEmpty());
  }
}

TEST(PairingProperty, APartnerThatDrivesOutOfEarshotCostsLittleTime) {  // P-6
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    pure::Random random{seed};
    AirWorld world{seed, CommunicationSettings{}};
    world.weather.loss = random.uniform(0.0, 0.5);
    world.add(3, path_of(3, 200));
    world.add(7, path_of(7, 200));
    world.run(below(random, 40));
    world.part(3, 7, true);
    world.run_for(10s);
    for (const auto& [id, robot] : world.robots()) EXPECT_LE(robot.stood, 2s + 40 * AirWorld::kStep);
    ASSERT_THAT(world.breaches, IsEmpty());
  }
}

}  // namespace
}  // namespace caravan::agent::testing
