// SPDX-License-Identifier: Apache-2.0
// P-58 to P-60, P-63: agents that come, go and come back, and two with the same robot.
#include <gmock/gmock.h>
#include <signal.h>

#include "tests/contract/agent/played_run.hpp"

namespace caravan::test {
namespace {

using ::testing::HasSubstr;

class Presence : public AgentContract {
 protected:
  /// As by kill -9; without its memory.
  void kill(AgentUnderTest& agent) {
    leftovers_.note(agent.pid());
    agent.signal(SIGKILL);
    ASSERT_TRUE(agent.wait(kPatience));
  }
  [[nodiscard]] bool is_gone() const {
    return eventually([&] { return listener_.agents() == 0; }, std::max(subject().patience, 60'000ms));
  }
};

TEST_F(Presence, P58IsGoneWhenItIsTerminated) {
  const auto agent = start_agent();
  ASSERT_NO_FATAL_FAILURE(drive(7, 0, 3));
  ASSERT_EQ(listener_.agents(), 1U);
  agent->signal(SIGTERM);
  EXPECT_TRUE(agent->wait(subject().patience)) << "it does not end on SIGTERM. " << log();
  EXPECT_TRUE(is_gone());
}

TEST_F(Presence, P58FollowsTheNextWorldWhenItsWorldIsGone) {
  const auto agent = start_agent();
  ASSERT_NO_FATAL_FAILURE(drive(7, 0, 3));
  world_.reset();
  world_ = std::make_unique<PlayedWorld>(bus("world_server"));
  drive(8, 0, 3);
}

TEST_F(Presence, P59WhenItWasKilledAndStartedAgainItAnswersTheNewestFrame) {
  const auto agent = start_agent();
  ASSERT_NO_FATAL_FAILURE(drive(7, 0, 9));
  ASSERT_NO_FATAL_FAILURE(kill(*agent));
  EXPECT_TRUE(is_gone()) << "P-58: when its lease has expired";
  const auto next = start_agent();
  EXPECT_TRUE(commands(7, 9, 2)) << "the world waits for it, and sends no other frame. " << log();
}

TEST_F(Presence, P60AnswersWhenItHasBeenSuspended) {
  const auto agent = start_agent();
  ASSERT_NO_FATAL_FAILURE(drive(7, 0, 3));
  ASSERT_TRUE(transmits(7, 3)) << log();
  agent->signal(SIGSTOP);
  world_->send(frame_of(7, 4));
  agent->signal(SIGCONT);
  EXPECT_TRUE(commands(7, 4)) << log();
}

TEST_F(Presence, P63OfTwoWithOneRobotTheSecondEndsAndNamesTheFirst) {
  const auto first = start_agent();
  ASSERT_NO_FATAL_FAILURE(drive(7, 0, 3));
  const runtime::Identity identity = listener_.identity();
  if (!identity.role.starts_with("robot_agent"))
    GTEST_SKIP() << "of another make: it states no role in its participant's name (P-80)";
  const auto second = start_agent();
  EXPECT_EQ(second->wait(subject().patience), 2) << second->output();
  EXPECT_THAT(second->output(), HasSubstr("robot 1 "));
  EXPECT_THAT(second->output(), HasSubstr(identity.host));
  EXPECT_THAT(second->output(), HasSubstr(std::to_string(identity.pid)));
  drive(7, 4, 9);
  for (int step = 4; step <= 9; ++step)
    EXPECT_EQ(listener_.answer(7, step).commands.size(), 1U) << "both answer step " << step;
}

}  // namespace
}  // namespace caravan::test
