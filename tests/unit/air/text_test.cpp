// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/radio/frames/text.hpp"

#include <gtest/gtest.h>

namespace caravan::agent {
namespace {

constexpr RobotId kThree{3};
constexpr RobotId kSeven{7};

TEST(FrameText, IsTheFormOfThePapersLogs) {
  EXPECT_EQ(to_text(Wait{kThree, Mode::kExplore, Engagement::kFree, {}}), "WAIT_3_EXPLORE");
  EXPECT_EQ(to_text(Wait{kThree, Mode::kTransport, Engagement::kFree, {}}), "WAIT_3_TRANSPORT");
  EXPECT_EQ(to_text(Accept{kSeven, kThree, 9, Mode::kExplore}), "ACCEPT_7-3");
  EXPECT_EQ(to_text(AcceptAck{kThree, kSeven, 9}), "ACCEPTACK_3-7");
  EXPECT_EQ(to_text(Reject{kThree, kSeven, 9, Refusal::kBusy}), "REJECT_3-7");
  EXPECT_EQ(to_text(End{kSeven, kThree, 9}), "END_7-3");
}

TEST(FrameText, AnyEngagementShowsAsBusy) {
  EXPECT_EQ(to_text(Wait{kThree, Mode::kExplore, Engagement::kNegotiating, kSeven}), "WAIT_3_BUSY");
  EXPECT_EQ(to_text(Wait{kThree, Mode::kExplore, Engagement::kInSession, kSeven}), "WAIT_3_BUSY");
  EXPECT_EQ(to_text(Wait{kThree, Mode::kTransport, Engagement::kAway, {}}), "WAIT_3_BUSY");
}

TEST(FrameText, AFragmentShowsWhichPointsOfHowMany) {
  PathFragment path{kSeven, kThree, 9, 50, 20, true, 0, {{1, 1}, {2, 2}, {3, 3}}};
  EXPECT_EQ(to_text(path), "PATH_7-3_20..22/50");
  path.points.clear();
  EXPECT_EQ(to_text(path), "PATH_7-3_-/50");
}

}  // namespace
}  // namespace caravan::agent
