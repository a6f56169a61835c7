// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/radio/pairing/can_communicate.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace caravan::agent {
namespace {

using namespace std::chrono_literals;
constexpr RobotId kPartner{7};

struct CanCommunicate : testing::Test {
  SharingSettings sharing;
  Contacts contacts;
  Time now = 20min;
  [[nodiscard]] bool may(Mode own, Mode partners) const {
    return can_communicate(sharing, contacts, own, kPartner, partners, now);
  }
};

TEST_F(CanCommunicate, InFullModeOneOfTheTwoMustHaveAPath) {  // P-20
  EXPECT_FALSE(may(Mode::kExplore, Mode::kExplore));
  EXPECT_TRUE(may(Mode::kExplore, Mode::kTransport));
  EXPECT_TRUE(may(Mode::kTransport, Mode::kExplore));
  EXPECT_TRUE(may(Mode::kTransport, Mode::kTransport));
}

TEST_F(CanCommunicate, InPartialModeExactlyOneOfTheTwoMustHaveAPath) {  // P-20
  sharing.mode = Sharing::kPartial;
  EXPECT_FALSE(may(Mode::kExplore, Mode::kExplore));
  EXPECT_TRUE(may(Mode::kExplore, Mode::kTransport));
  EXPECT_TRUE(may(Mode::kTransport, Mode::kExplore));
  EXPECT_FALSE(may(Mode::kTransport, Mode::kTransport));
}

TEST_F(CanCommunicate, InModeNoneNobodyPairs) {  // P-20
  sharing.mode = Sharing::kNone;
  EXPECT_FALSE(may(Mode::kExplore, Mode::kTransport));
  EXPECT_FALSE(may(Mode::kTransport, Mode::kTransport));
}

TEST_F(CanCommunicate, NobodyPairsBeforeSharingStarts) {  // P-21
  now = sharing.starts - 1ns;
  EXPECT_FALSE(may(Mode::kExplore, Mode::kTransport));
  now = sharing.starts;
  EXPECT_TRUE(may(Mode::kExplore, Mode::kTransport));
}

TEST_F(CanCommunicate, ARobotToBeAvoidedIsEligibleAgainAtTheMomentSet) {  // P-22
  contacts.avoid_until(kPartner, now + 10min);
  contacts.avoid_until(kPartner, now + 1s);  // never shortens
  EXPECT_FALSE(may(Mode::kTransport, Mode::kTransport));
  EXPECT_TRUE(can_communicate(sharing, contacts, Mode::kTransport, RobotId{8}, Mode::kTransport, now));
  now += 10min - 1ns;
  EXPECT_FALSE(may(Mode::kTransport, Mode::kTransport));
  now += 1ns;
  EXPECT_TRUE(may(Mode::kTransport, Mode::kTransport));
}

TEST(Contacts, AllowOneRejectionASecondToEachRobot) {  // P-34
  Contacts contacts;
  EXPECT_TRUE(contacts.may_reject(RobotId{7}, 5s, 1s));
  EXPECT_FALSE(contacts.may_reject(RobotId{7}, 5999ms, 1s));
  EXPECT_TRUE(contacts.may_reject(RobotId{3}, 5999ms, 1s));
  EXPECT_TRUE(contacts.may_reject(RobotId{7}, 6s, 1s));
}

TEST(PrivateChannel, IsDistinctForAllPairsOfAThousandRobotsAtTheDefaultChannelCount) {  // P-35
  const std::uint32_t count = Air{}.channel_count;
  std::vector<bool> taken(count);
  for (std::uint16_t high = 2; high <= 1000; ++high) {
    for (std::uint16_t low = 1; low < high; ++low) {
      const Channel channel = private_channel(RobotId{high}, RobotId{low}, count);
      ASSERT_NE(channel, kCommonChannel);
      ASSERT_LT(channel.value, count);
      ASSERT_FALSE(taken[channel.value]) << high << " and " << low;
      taken[channel.value] = true;
    }
  }
}

TEST(PrivateChannel, IsTheSameForBothAndNeverTheCommonOne) {  // P-35
  for (const std::uint32_t count : {2U, 3U, 16U}) {
    for (std::uint16_t id = 2; id < 200; ++id) {
      const Channel channel = private_channel(RobotId{1}, RobotId{id}, count);
      EXPECT_EQ(channel, private_channel(RobotId{id}, RobotId{1}, count));
      EXPECT_GE(channel.value, 1U);
      EXPECT_LT(channel.value, count);
    }
  }
  EXPECT_EQ(private_channel(RobotId{2}, RobotId{11}, 1U << 20U).value, 58U);
}

}  // namespace
}  // namespace caravan::agent
