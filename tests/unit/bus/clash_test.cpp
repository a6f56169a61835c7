// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/clash.hpp"

#include <gtest/gtest.h>

namespace caravan::runtime {
namespace {

using namespace std::chrono_literals;

const Clash::Wall kBegan{100s};
constexpr double kLease_s = 5.0;
constexpr auto kPatience = 5500ms;
constexpr std::uint64_t kStarted_ms = 1'000'000;

ParticipantId participant(std::uint8_t number) {
  ParticipantId id;
  id.prefix[0] = number;
  return id;
}
Clash clash() { return {participant(5), {"robot_agent 1", "lab", 10, kStarted_ms}, kLease_s, kBegan}; }
Identity agent(std::uint64_t started_ms) { return {"robot_agent 1", "lab", 11, started_ms}; }
Identity agent_elsewhere(std::uint64_t started_ms) { return {"robot_agent 1", "hall", 11, started_ms}; }

TEST(Clash, GivesWayToOneThatStartedEarlierUntilItVanishes) {
  Clash one = clash();
  EXPECT_TRUE(one.found(1, participant(9), agent(kStarted_ms - 2000), false, kBegan + 1s));
  EXPECT_TRUE(one.must_be_silent());
  EXPECT_EQ(one.deadline(), kBegan + 1s + kPatience);
  EXPECT_FALSE(one.lost_to(kBegan + 1s));
  EXPECT_TRUE(one.lost_to(kBegan + 1s + kPatience));
  one.vanished(participant(9));
  EXPECT_FALSE(one.must_be_silent());
  EXPECT_FALSE(one.lost_to(kBegan + 1s + kPatience));
}

TEST(Clash, OfTwoThatStartedTogetherTheLowerGuidStays) {
  Clash one = clash();
  EXPECT_FALSE(one.found(1, participant(9), agent_elsewhere(kStarted_ms - 500), false, kBegan));
  EXPECT_TRUE(one.found(1, participant(2), agent_elsewhere(kStarted_ms + 500), false, kBegan));
}

TEST(Clash, OfTwoThatStartedTogetherTheOneThatIsInUseStays) {
  Clash one = clash();
  EXPECT_FALSE(one.found(1, participant(2), agent_elsewhere(kStarted_ms + 500), true, kBegan));
  EXPECT_TRUE(one.found(1, participant(2), agent_elsewhere(kStarted_ms - 2000), true, kBegan));
}

TEST(Clash, OfTwoOnOneHostTheOneThatStartedFirstStaysHoweverShortBefore) {
  Clash one = clash();
  EXPECT_FALSE(one.found(1, participant(2), agent(kStarted_ms + 1), false, kBegan));
  EXPECT_TRUE(one.found(1, participant(9), agent(kStarted_ms - 1), true, kBegan));
}

TEST(Clash, StaysBesideOneThatStartedLater) {
  Clash one = clash();
  EXPECT_FALSE(one.found(1, participant(2), agent(kStarted_ms + 2000), false, kBegan));
  EXPECT_FALSE(one.must_be_silent());
}

TEST(Clash, StaysBesideAWriterOfAnotherMakeOrRole) {
  Clash one = clash();
  EXPECT_FALSE(one.found(1, participant(2), Identity{}, false, kBegan));
  EXPECT_FALSE(one.found(1, participant(2), {"/talker", "", 0, 0}, false, kBegan));
  EXPECT_FALSE(one.found(1, participant(2), {"launcher", "lab", 3, kStarted_ms - 9000}, false, kBegan));
  EXPECT_FALSE(one.must_be_silent());
}

TEST(Clash, StaysBesideWhoeverComesLongAfterTheStartWhateverItStates) {
  Clash one = clash();
  EXPECT_FALSE(one.found(1, participant(2), agent(1), false, kBegan + kPatience + 1ms));
  EXPECT_FALSE(one.must_be_silent());
}

}  // namespace
}  // namespace caravan::runtime
