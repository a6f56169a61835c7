// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/task/gripper.hpp"

#include <gmock/gmock.h>

namespace caravan::agent {
namespace {

using namespace std::chrono_literals;
using Change = Gripper::Change;

TEST(Gripper, ClosesAtTheSourceAndOpensAtTheDestination) {
  Gripper gripper;
  EXPECT_FALSE(gripper.closed());
  gripper.arrive_at_source(1s);
  EXPECT_TRUE(gripper.closed());
  EXPECT_EQ(gripper.sense(false, 1s), Change::kNone);
  EXPECT_EQ(gripper.sense(true, 1032ms), Change::kPickedUp);
  EXPECT_EQ(gripper.sense(true, 20s), Change::kNone);
  gripper.arrive_at_destination(60s);
  EXPECT_FALSE(gripper.closed());
  EXPECT_EQ(gripper.sense(true, 60s), Change::kNone);
  EXPECT_EQ(gripper.sense(false, 60032ms), Change::kDelivered);
}

TEST(Gripper, BelievesOnlyWhatHoldingSays) {
  Gripper gripper;
  gripper.arrive_at_source(0s);
  EXPECT_EQ(gripper.sense(false, 200ms), Change::kNone);
  EXPECT_EQ(gripper.sense(false, 300ms), Change::kNothingThere);
  EXPECT_FALSE(gripper.closed());
  gripper.arrive_at_destination(60s);
  EXPECT_EQ(gripper.sense(false, 61s), Change::kNone) << "nothing was delivered";
}

TEST(Gripper, AnItemThatStaysInTheOpenGripperIsCarriedOn) {
  Gripper gripper;
  gripper.arrive_at_source(0s);
  (void)gripper.sense(true, 32ms);
  gripper.arrive_at_destination(60s);
  EXPECT_EQ(gripper.sense(true, 61s), Change::kNotDelivered);
  EXPECT_TRUE(gripper.closed());
}

}  // namespace
}  // namespace caravan::agent
