// SPDX-License-Identifier: Apache-2.0
// P-51, P-62: sessions, and whose frames count.
#include <gmock/gmock.h>

#include "tests/contract/agent/played_run.hpp"

namespace caravan::test {
namespace {

using ::testing::Contains;
using ::testing::Not;

TEST_F(AgentContract, P51AnswersTheFirstFrameOfAHigherSession) {
  const auto agent = start_agent();
  ASSERT_NO_FATAL_FAILURE(drive(7, 0, 9));
  drive(8, 0, 9);
}

TEST_F(AgentContract, P51AFrameOfALowerSessionHasNoEffect) {
  const auto agent = start_agent();
  ASSERT_NO_FATAL_FAILURE(drive(8, 0, 4));
  world_->send(frame_of(7, 5));
  ASSERT_NO_FATAL_FAILURE(drive(8, 5, 9));
  EXPECT_THAT(listener_.sessions(), Not(Contains(7U)));
}

class Reset : public AgentContract {
 protected:
  /// What the agent decides in a session's first steps.
  std::string decisions(std::uint64_t session) {
    std::string text;
    for (int step = 0; step < 60; ++step) {
      drive(session, step, step);
      if (HasFatalFailure() || !transmits(session, step)) return "";
      const Answer answer = listener_.answer(session, step);
      const msg::RobotCommand& command = answer.commands.front();
      text += testing::PrintToString(
          std::tuple{step, command.left_mps(), command.right_mps(), command.gripper_closed()});
      for (const msg::RadioFrame& frame : answer.transmits.front().frames())
        text += testing::PrintToString(std::pair{frame.channel(), frame.bytes()});
      text += '\n';
    }
    return text;
  }
};

TEST_F(Reset, P51ANewSessionFindsTheAgentInItsInitialState) {
  auto agent = start_agent();
  const std::string first = decisions(7);
  agent.reset();
  ASSERT_TRUE(eventually([&] { return listener_.agents() == 0; }, kPatience)) << log();
  world_.reset();  // its last frames would be the first that the next agent gets
  world_ = std::make_unique<PlayedWorld>(bus("world_server"));
  agent = start_agent();
  const std::string restarted = decisions(8);
  ASSERT_FALSE(HasFailure());
  if (first != restarted) {
    GTEST_SKIP() << "started twice, the agent answers the same frames in two ways, so its initial state "
                    "cannot be seen from outside";
  }
  EXPECT_EQ(decisions(9), restarted) << "in a new session the same frames have other answers";
}

TEST_F(AgentContract, P62FramesOfAnotherWorldCountOnlyWhenTheFirstIsGone) {
  const auto agent = start_agent();
  ASSERT_NO_FATAL_FAILURE(drive(7, 0, 4));
  PlayedWorld other{bus("world_server")};
  ASSERT_TRUE(eventually([&] { return other.has_reader(); }, kPatience)) << log();
  other.send(frame_of(9, 0));
  ASSERT_NO_FATAL_FAILURE(drive(7, 5, 40));
  EXPECT_THAT(listener_.sessions(), Not(Contains(9U))) << "it answers two worlds";
  world_.reset();
  EXPECT_TRUE(commands(9, 0)) << "the first world is gone, and the other one waits for its answer. " << log();
}

}  // namespace
}  // namespace caravan::test
