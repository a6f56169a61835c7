// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cfenv>

#include "build_paths.hpp"
#include "robot_agent/config/agent_config.hpp"
#include "robot_agent/controller/controllers.hpp"
#include "robot_agent/controller/paper_controller.hpp"
#include "runtime/controller/library.hpp"

namespace caravan::agent {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kFolder = CARAVAN_BIN_DIR "/../tests/controllers/";

std::string scenario_text(const std::string& controller) {
  return "[robots]\ncount = 4\nsource_m = [0.0, 0.0]\ndestination_m = [3.0, 0.0]\n[controller]\n" +
         controller;
}

runtime::TomlDocument scenario(const std::string& controller) {
  return runtime::TomlDocument::parse(scenario_text(controller), "mine.toml");
}

runtime::TomlDocument with_library(const std::string& name, const std::string& keys = "") {
  return scenario("library = \"" + kFolder + name + ".so\"\n" + keys);
}

/// The error for the controller of robot 2; empty if there is none.
std::string refusal(const runtime::TomlDocument& document) {
  try {
    (void)Controllers{document}.make(load_config(document, 2));
  } catch (const runtime::StartError& error) {
    return error.what();
  }
  return "";
}

std::string fault_of(const std::string& fault) {
  const auto document = with_library("faulty", "fault = \"" + fault + "\"\n");
  auto controller = Controllers{document}.make_guarded(load_config(document, 2));
  try {
    for (int step = 0; step < 5; ++step)
      (void)controller.step(
          {.now = step * std::chrono::milliseconds{32}, .sensors = {}, .heard = {}, .destination = {}});
  } catch (const runtime::ControllerFault& error) {
    return error.what();
  }
  return "";
}

TEST(Controllers, AreThePapersUnlessTheScenarioNamesALibrary) {
  EXPECT_EQ(Controllers{scenario("")}.name(), "paper");
  EXPECT_EQ(Controllers{scenario("library = \"paper\"\n")}.name(), "paper");
  EXPECT_EQ(Controllers{with_library("chatterer")}.name(), "chatterer");
}

TEST(Controllers, ReadTheirOwnKeysStrictly) {
  EXPECT_EQ(refusal(with_library("chatterer", "cruise_mps = 0.3\n")), "");
  EXPECT_EQ(refusal(with_library("chatterer", "cruise_mps = -1\n")),
            "mine.toml:7: controller.cruise_mps: must be from 0 to 1, is -1");
  EXPECT_EQ(refusal(with_library("chatterer", "cruise = 0.3\n")),
            "mine.toml:7: controller.cruise: unknown key; controller chatterer has: cruise_mps");
  EXPECT_EQ(refusal(with_library("faulty", "fault = \"default\"\n")),
            "mine.toml:5: controller.gain: its default is 3, outside its own limits: 0 to 2");
  EXPECT_THAT(refusal(with_library("chatterer", "cruise_mps = {}\n")),
              StartsWith("mine.toml:7: controller.cruise_mps: must be"));
  EXPECT_EQ(refusal(scenario("cruise_mps = 0.3\n")),
            "mine.toml:6: controller.cruise_mps: unknown key; controller paper has no keys")
      << "the paper's agent has its keys elsewhere";
}

TEST(Controllers, NameALibraryThatCannotBeUsed) {
  EXPECT_THAT(refusal(with_library("missing")), HasSubstr("missing.so: there is no such file"));
  EXPECT_THAT(refusal(scenario("library = \"" + std::string{CARAVAN_SOURCE_DIR} + "/README.md\"\n")),
              HasSubstr("README.md: is not a shared library; compile it first"));
  EXPECT_THAT(refusal(with_library("no_entry")), HasSubstr("add CARAVAN_CONTROLLER(Class, \"name\")"));
  EXPECT_THAT(refusal(with_library("other_interface")),
              HasSubstr("was built for version 2 of the controller interface, this program has version 1"));
  EXPECT_THAT(refusal(with_library("no_name")), EndsWith("no_name.so: has no name"));
  EXPECT_THAT(refusal(with_library("other_name")),
              EndsWith("has the name \"My Swarm\", must be lower_snake_case, of 1 to 64 characters"));
  EXPECT_THAT(refusal(with_library("faulty", "fault = \"constructor\"\n")),
              StartsWith("controller faulty, robot 2: cannot be made: no map"));
  EXPECT_EQ(refusal(with_library("faulty", "fault = \"constructor_throws_no_text\"\n")),
            "controller faulty, robot 2: cannot be made: (without a text)");
  EXPECT_EQ(refusal(with_library("makes_none")),
            "controller makes_none, robot 2: cannot be made: the library made no controller");
}

TEST(Controllers, ArePathsFromTheScenariosFolder) {
  const auto document =
      runtime::TomlDocument::parse("[controller]\nlibrary = \"lib/mine.so\"\n", "/a/b/mine.toml");
  EXPECT_EQ(controller_in(document), "/a/b/lib/mine.so");
}

TEST(Controllers, ThatFailAreNamedWithRobotAndStep) {
  EXPECT_EQ(fault_of("none"), "");
  EXPECT_EQ(fault_of("throws"),
            "controller faulty, robot 2, step 3 (0.064 s): threw an exception: no such cell");
  EXPECT_EQ(fault_of("throws_a_number"),
            "controller faulty, robot 2, step 3 (0.064 s): threw something that is no std::exception");
  EXPECT_EQ(fault_of("throws_no_text"),
            "controller faulty, robot 2, step 3 (0.064 s): threw an exception: (without a text)");
  EXPECT_THAT(fault_of("nan"), HasSubstr("step 3 (0.064 s): wheel speeds nan and 0.1"));
  EXPECT_EQ(
      fault_of("event"),
      "controller faulty, robot 2, step 3 (0.064 s): the name of an event, \"Hello\\nworld\", is not in "
      "lower_snake_case");
}

/// The outputs of robot 2 in step 3, and what was said by then, when all that a radio drops is sent twice.
struct Third {
  caravan::Outputs outputs;
  std::vector<std::string> warnings;
};
Third third_step(const Controllers& controllers, const runtime::TomlDocument& document) {
  auto controller = controllers.make_guarded(load_config(document, 2));
  Third third;
  for (int step = 0; step < 3; ++step) {
    third.outputs = controller.step(
        {.now = step * std::chrono::milliseconds{32}, .sensors = {}, .heard = {}, .destination = {}});
    third.warnings.insert(third.warnings.end(), controller.warnings().begin(), controller.warnings().end());
  }
  return third;
}

TEST(Controllers, AreToldOnceOfEachKindOfFrameThatTheRadioDrops) {
  const std::vector<std::pair<std::string, std::string>> faults = {
      {"long_frame", "the radio drops a frame of 5000 bytes: radio.mtu_bytes is 250"},
      {"bad_channel", "the radio drops a frame on channel 4294967295: the channels are 0 to 1048575"},
      {"bad_tuned",
       "nothing is heard on channel 4294967295, which it tunes to: the channels are 0 to 1048575"}};
  for (const auto& [fault, said] : faults) {
    const auto document = with_library("faulty", "fault = \"" + fault + "\"\n");
    const Controllers controllers{document};
    EXPECT_THAT(third_step(controllers, document).warnings,
                testing::ElementsAre("controller faulty, robot 2, step 3 (0.064 s): " + said +
                                     "; this is said once"));
    EXPECT_THAT(third_step(controllers, document).warnings, testing::IsEmpty()) << "by the next controller";
  }
  const auto sound = with_library("faulty");
  EXPECT_THAT(third_step(Controllers{sound}, sound).warnings, testing::IsEmpty());
}

TEST(Controllers, HaveNoControlCharactersInTheDetailsOfTheirEvents) {
  const auto document = with_library("faulty", "fault = \"detail\"\n");
  const Third third = third_step(Controllers{document}, document);
  ASSERT_TRUE(third.outputs.report);
  EXPECT_EQ(third.outputs.report->events[0].detail, "a\\nb");
}

TEST(Controllers, ThatExceedALimitOfTheOutputsAreNamedWithTheValue) {
  const std::string where = "controller faulty, robot 2, step 3 (0.064 s): ";
  EXPECT_EQ(fault_of("frames"), where + "frames has 1001 elements, more than 1000");
  EXPECT_EQ(fault_of("frame_bytes"), where + "frames have 2097152 bytes together, more than 1048576");
  EXPECT_EQ(fault_of("report_mode"), where + "report.mode = 99 is none of its enumeration");
  EXPECT_EQ(fault_of("report_activity"), where + "report.activity = 99 is none of its enumeration");
  EXPECT_EQ(fault_of("report_origin"), where + "report.origin = 99 is none of its enumeration");
  EXPECT_EQ(fault_of("report_nan"), where + "report.path[1] = (1, nan) is not within 1000000 m of zero");
  EXPECT_EQ(fault_of("report_far"), where + "report.path[1] = (1e+12, 1) is not within 1000000 m of zero");
  EXPECT_EQ(fault_of("report_long_path"), where + "report.path has 65536 elements, more than 65535");
  EXPECT_EQ(fault_of("report_exchanges"), where + "report.exchanges has 101 elements, more than 100");
  EXPECT_THAT(fault_of("report_exchange_early"), StartsWith(where + "report.exchanges[0] began at -5 ns"));
  EXPECT_THAT(fault_of("report_exchange_late"), HasSubstr("ended at 9223372036854775807 ns, must"));
  EXPECT_EQ(fault_of("report_events"), where + "report.events has 101 elements, more than 100");
  EXPECT_EQ(fault_of("report_long_event"), where + "report.events[0] has 5006 bytes, more than 4096");
  EXPECT_EQ(fault_of("report_long_escaped_event"), where + "report.events[0] has 6006 bytes, more than 4096");
  EXPECT_EQ(fault_of("report_event_bytes"), where + "report.events[0].detail is not UTF-8 without NUL");
  EXPECT_EQ(fault_of("report_event_nul"), where + "report.events[0].detail is not UTF-8 without NUL");
  EXPECT_EQ(fault_of("report_most"), "") << "all at their limits";
}

TEST(Controllers, ChangeNoRoundingOutsideOfTheirCalls) {
  const auto document = with_library("rounds_up");
  const Controllers controllers{document};
  EXPECT_EQ(std::fegetround(), FE_TONEAREST) << "loaded";
  auto controller = controllers.make_guarded(load_config(document, 2));
  EXPECT_EQ(std::fegetround(), FE_TONEAREST) << "made";
  (void)controller.step({.now = {}, .sensors = {}, .heard = {}, .destination = {}});
  EXPECT_EQ(std::fegetround(), FE_TONEAREST) << "called";
  std::fesetround(FE_TONEAREST);
}

caravan::Inputs inputs_at(int step, double ahead_m) {
  caravan::Inputs inputs{
      .now = step * std::chrono::milliseconds{32}, .sensors = {}, .heard = {}, .destination = {}};
  inputs.sensors.sonar_range_m.fill(ahead_m);
  if (step % 3 == 0) inputs.heard.push_back({.channel = 0, .bytes = {static_cast<std::uint8_t>(step)}});
  return inputs;
}

TEST(Controllers, InOneProcessShareNothing) {
  for (const auto& document : {with_library("chatterer"), scenario("")}) {
    const Controllers controllers{document};
    const Config config = load_config(document, 1);
    const auto alone = controllers.make(config);
    const auto together = controllers.make(config);
    const auto other = controllers.make(load_config(document, 2));
    for (int step = 0; step < 200; ++step) {
      const auto expected = alone->step(inputs_at(step, 2.0));
      (void)other->step(inputs_at(step, 0.5));
      const auto outputs = together->step(inputs_at(step, 2.0));
      ASSERT_EQ(outputs.left_mps, expected.left_mps) << step;
      ASSERT_EQ(outputs.right_mps, expected.right_mps) << step;
      ASSERT_EQ(outputs.frames.size(), expected.frames.size()) << step;
      for (std::size_t i = 0; i < outputs.frames.size(); ++i)
        ASSERT_EQ(outputs.frames[i].bytes, expected.frames[i].bytes) << step;
    }
  }
}

TEST(DestinationInSight, IsGivenNearByAndInFrontOfObstaclesOnly) {
  const Config config = load_config(scenario(""), 1);
  caravan::Sensors sensors;
  sensors.sonar_range_m.fill(std::numeric_limits<double>::infinity());
  const auto seen = destination_in_sight(sensors, config);
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->x_m, 3.0);
  EXPECT_EQ(seen->y_m, 0.0);
  sensors.position.x_m = -1.5;
  EXPECT_FALSE(destination_in_sight(sensors, config)) << "4.5 m away";
  sensors.position.x_m = 0.0;
  sensors.sonar_range_m.fill(1.0);
  EXPECT_FALSE(destination_in_sight(sensors, config)) << "something stands in between";
  sensors.position.x_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(destination_in_sight(sensors, config));
}

}  // namespace
}  // namespace caravan::agent
