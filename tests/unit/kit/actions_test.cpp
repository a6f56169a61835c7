// SPDX-License-Identifier: Apache-2.0
#include "deploy/kit/actions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "build_paths.hpp"
#include "deploy/kit/quantities.hpp"

namespace caravan::deploy {
namespace {

using Kind = ProcessAction::Kind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

ProcessAction process_action(const std::string& line) {
  return std::get<ProcessAction>(read_action(line, 4));
}

TEST(Actions, NameProcesses) {
  EXPECT_THAT(process_action("start all").names,
              ElementsAre("world", "radio", "robot 1", "robot 2", "robot 3", "robot 4"));
  EXPECT_THAT(process_action("kill robot 2,4").names, ElementsAre("robot 2", "robot 4"));
  EXPECT_THAT(process_action("stop robots").names, ElementsAre("robot 1", "robot 2", "robot 3", "robot 4"));
  EXPECT_THAT(process_action("restart world").names, ElementsAre("world"));
  EXPECT_EQ(process_action("kill radio").kind, Kind::kKill);
  EXPECT_EQ(process_action("suspend robot 1").kind, Kind::kSuspend);
  EXPECT_EQ(process_action("continue robot 1").kind, Kind::kContinue);
}

TEST(Actions, HoldStepAndControl) {
  EXPECT_TRUE(std::holds_alternative<Go>(read_action("go", 4)));
  EXPECT_EQ(std::get<HoldAt>(read_action("hold_at 900", 4)).step, 900U);
  const auto until =
      std::get<StepUntil>(read_action("step_until 30 activity 3 is exchanging and step > 30", 4));
  EXPECT_EQ(until.most, 30U);
  EXPECT_EQ(until.condition.text(), " activity 3 is exchanging and step > 30");
  const auto request =
      std::get<caravan_interfaces::msg::ControlRequest>(read_action("radio cut 1 2 at 50", 4));
  EXPECT_EQ(request.at_step(), 50U);
}

TEST(Actions, SayWhatIsWrong) {
  const std::vector<std::pair<std::string, std::string>> cases{{"", "empty"},
                                                               {"kill", "is missing"},
                                                               {"kill everybody", "is not a process"},
                                                               {"kill robot 5", "no robot 5"},
                                                               {"kill robot", "is missing"},
                                                               {"go home", "too many"},
                                                               {"hold_at 0", "step 0"},
                                                               {"explode", "there is no action \"explode\""}};
  for (const auto& [line, reason] : cases) {
    try {
      (void)read_action(line, 4);
      ADD_FAILURE() << line << " was taken";
    } catch (const WordsError& error) {
      EXPECT_THAT(error.what(), HasSubstr(reason)) << line;
    }
  }
}

/// The tables of the tutorial agree with the kit.
TEST(Actions, AreDocumentedAsTheyAre) {
  std::ifstream page{CARAVAN_SOURCE_DIR "/docs/deployment_tests.md"};
  std::stringstream text;
  text << page.rdbuf();
  for (const ActionForm& form : action_forms())
    EXPECT_THAT(text.str(), HasSubstr("| `" + std::string{form.form} + "` |"));
  for (const ControlForm& form : control_forms())
    EXPECT_THAT(text.str(), HasSubstr("| `" + std::string{form.form} + "` |"));
  for (const QuantityForm& form : quantity_forms())
    EXPECT_THAT(text.str(), HasSubstr("| `" + std::string{form.form} + "` |"));
}

}  // namespace
}  // namespace caravan::deploy
