// SPDX-License-Identifier: Apache-2.0
// P-51, P-56, P-61: waiting for the radio. That it waits is seen by a lower bound of its time. That it does
// not wait longer than for the sample is seen by the shortest of several times, because a busy machine
// delays some of them.
#include <algorithm>
#include <thread>

#include "tests/contract/agent/played_run.hpp"

namespace caravan::test {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr Seconds kMost{1.0};        // that an agent waits for its radio
constexpr Seconds kNearlyMost{0.9};  // its clock may differ
constexpr int kTries = 10;

class RadioRules : public AgentContract {
 protected:
  void SetUp() override {
    agent_ = start_agent();
    ASSERT_NO_FATAL_FAILURE(drive(7, 0, 3));
    if (!agent_uses_radio())
      GTEST_SKIP() << "the agent does not read " << idl::name_for(idl::kRadioReceive, kRobot);
  }
  void send_due(std::uint64_t session, int step) {
    msg::SensorFrame frame = frame_of(session, step);
    frame.radio_due(true);
    world_->send(frame);
  }
  /// Wall time until the step is answered.
  [[nodiscard]] Seconds answered_within(std::uint64_t session, int step) const {
    const auto began = Clock::now();
    EXPECT_TRUE(commands(session, step)) << "step " << step << ". " << log();
    return Clock::now() - began;
  }

  std::unique_ptr<AgentUnderTest> agent_;
  PlayedRadio radio_{bus("radio_emulator")};
};

TEST_F(RadioRules, P56WaitsASecondForARadioThatIsDueAndThenStepsWithoutIt) {
  for (const int step : {4, 6, 8}) {
    radio_.send(7, step - 1);  // what is of another step does not count
    send_due(7, step);
    EXPECT_GE(answered_within(7, step), kNearlyMost) << "it has not waited for its radio";
    if (HasFailure()) return;
    drive(7, step + 1, step + 1);
  }
}

TEST_F(RadioRules, P56AnswersAsSoonAsTheRadioHasCome) {
  for (const bool radio_is_first : {true, false}) {
    Seconds shortest = kMost;
    for (int step = 4; step < 4 + kTries && shortest > kMost / 2; ++step) {
      const std::uint64_t session = radio_is_first ? 7 : 8;
      if (radio_is_first) radio_.send(session, step);
      send_due(session, step);
      if (!radio_is_first) {
        std::this_thread::sleep_for(50ms);
        radio_.send(session, step);
      }
      shortest = std::min(shortest, answered_within(session, step));
      if (HasFailure()) return;
    }
    EXPECT_LT(shortest, kMost / 2) << "it waits although its radio has come, "
                                   << (radio_is_first ? "before" : "after") << " the frame";
  }
}

TEST_F(RadioRules, P51KeepsWhatItsRadioSendsOfASessionThatIsStillToCome) {
  Seconds shortest = kMost;
  for (std::uint64_t session = 8; session < 8 + kTries && shortest > kMost / 2; ++session) {
    radio_.send(session, 0);
    std::this_thread::sleep_for(50ms);
    send_due(session, 0);
    shortest = std::min(shortest, answered_within(session, 0));
    if (HasFailure()) return;
  }
  EXPECT_LT(shortest, kMost / 2) << "it has lost the RadioReceive that came before the first frame";
}

TEST_F(AgentContract, P61DrivesOnWithoutARadio) {
  const auto agent = start_agent();
  {
    PlayedRadio radio{bus("radio_emulator")};
    ASSERT_NO_FATAL_FAILURE(drive(7, 0, 3));
    radio.send(7, 4);
    msg::SensorFrame due = frame_of(7, 4);
    due.radio_due(true);
    world_->send(due);
    ASSERT_TRUE(commands(7, 4)) << log();
  }
  drive(7, 5, 10);
}

}  // namespace
}  // namespace caravan::test
