// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <thread>

#include "build_paths.hpp"
#include "robot_agent/config/agent_config.hpp"
#include "robot_agent/controller/controllers.hpp"
#include "tests/support/sanitizers.hpp"

namespace caravan::agent {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kFolder = CARAVAN_SOURCE_DIR "/tests/controllers/python/";
constexpr std::chrono::milliseconds kStep{32};

class PythonController : public testing::Test {
 protected:
  void SetUp() override {
    if (test::kIsSanitized) GTEST_SKIP() << "the sanitizers report Python's own memory";
  }
};

runtime::TomlDocument with(const std::string& name, const std::string& keys = "") {
  return runtime::TomlDocument::parse(
      "seed = 7\n[robots]\ncount = 4\n[controller]\nlibrary = \"" + kFolder + name + ".py\"\n" + keys,
      "mine.toml");
}

caravan::Inputs inputs_at(int step) {
  caravan::Inputs inputs{.now = step * kStep, .sensors = {}, .heard = {}, .destination = {}};
  inputs.sensors.sonar_range_m.fill(2.0 + step);
  return inputs;
}

/// What is wrong with the controller of robot 2.
std::string refusal(const std::string& name, const std::string& keys = "") {
  try {
    const auto document = with(name, keys);
    (void)Controllers{document}.make(load_config(document, 2));
  } catch (const runtime::StartError& error) {
    return error.what();
  }
  return "";
}

std::string fault_of(const std::string& fault) {
  const auto document = with("faulty", "fault = \"" + fault + "\"\n");
  auto controller = Controllers{document}.make_guarded(load_config(document, 2));
  try {
    for (int step = 0; step < 5; ++step) (void)controller.step(inputs_at(step));
  } catch (const runtime::ControllerFault& error) {
    return error.what();
  }
  return "";
}

TEST_F(PythonController, IsNamedAfterItsFile) {
  EXPECT_EQ(Controllers{with("chatterer")}.name(), "chatterer");
}

TEST_F(PythonController, ReadsItsKeysStrictly) {
  EXPECT_EQ(refusal("chatterer", "cruise_mps = 0.3\n"), "");
  EXPECT_EQ(refusal("chatterer", "cruise_mps = -1\n"),
            "mine.toml:6: controller.cruise_mps: must be from 0 to 1, is -1");
  EXPECT_EQ(refusal("chatterer", "cruise = 0.3\n"),
            "mine.toml:6: controller.cruise: unknown key; controller chatterer has: cruise_mps");
  EXPECT_EQ(refusal("faulty", "fault = \"parameter\"\n"),
            "mine.toml:6: controller.fault: must be another one");
}

TEST_F(PythonController, SaysWhyItCannotBeMade) {
  const auto of = [](const std::string& name) {
    return "controller " + name + ", robot 2: cannot be made: ";
  };
  EXPECT_THAT(refusal("missing"), HasSubstr("missing.py: there is no such file"));
  EXPECT_EQ(
      refusal("missing_module"),
      of("missing_module") + "missing_module.py:4: ModuleNotFoundError: No module named 'no_such_module'");
  EXPECT_THAT(refusal("not_python"), StartsWith(of("not_python") + "not_python.py:3: SyntaxError: "));
  EXPECT_EQ(refusal("no_class"),
            of("no_class") + "no_class.py: TypeError: there is no class with a function step(self, inputs)");
  EXPECT_THAT(refusal("two_classes"), HasSubstr("more than one class with a function step: Left, Right;"));
  EXPECT_EQ(refusal("faulty", "fault = \"constructor\"\n"),
            of("faulty") + "faulty.py:18: RuntimeError: no map");
}

TEST_F(PythonController, IsNamedWithRobotStepAndLineWhenItFails) {
  const std::string where = "controller faulty, robot 2, step 3 (0.064 s): ";
  const std::string threw = where + "threw an exception: ";
  EXPECT_EQ(fault_of("none"), "");
  EXPECT_EQ(fault_of("throws"), threw + "faulty.py:31: KeyError: 'cell'");
  EXPECT_EQ(fault_of("throws_in_numpy"), threw + "faulty.py:34: LinAlgError: Singular matrix");
  EXPECT_EQ(fault_of("writes_a_sonar"),
            threw + "faulty.py:37: ValueError: assignment destination is read-only");
  EXPECT_THAT(fault_of("asks_late"),
              HasSubstr("faulty.py:41: RuntimeError: parameters are asked for in __init__"));
  EXPECT_EQ(fault_of("exits"), threw + "faulty.py:44: SystemExit: 0");
  EXPECT_EQ(fault_of("nothing"), threw + "TypeError: step() returned NoneType where Outputs is needed");
  EXPECT_EQ(fault_of("word_for_a_speed"),
            threw + "TypeError: step() returned Outputs.left_mps = 'fast', must be a number");
  EXPECT_THAT(fault_of("negative_channel"),
              HasSubstr("Outputs.tuned_channel = -1, must be an integer from 0"));
  EXPECT_THAT(fault_of("frame_of_text"), HasSubstr("Frame.bytes = 'hello', must be bytes"));
  EXPECT_THAT(fault_of("no_frame"), HasSubstr("step() returned bytes where Frame is needed"));
  EXPECT_EQ(fault_of("far_path"), where + "report.path[0] = (inf, 1) is not within 1000000 m of zero");
  EXPECT_THAT(fault_of("calls_wrongly"),
              HasSubstr("TypeError: wrong arguments, number() takes (key: str, otherwise"));
  EXPECT_THAT(fault_of("calls_wrongly"), EndsWith("low: float = lowest, high: float = highest)"));
  EXPECT_EQ(fault_of("nan"), where + "wheel speeds nan and 0.100000 m/s are not finite");
}

TEST_F(PythonController, SharesNoGlobalsWithAnotherOfItsFile) {
  const auto document = with("counter");
  const Controllers controllers{document};
  const auto one = controllers.make(load_config(document, 1));
  const auto other = controllers.make(load_config(document, 2));
  for (int step = 0; step < 3; ++step) (void)other->step(inputs_at(step));
  const auto outputs = one->step(inputs_at(0));
  EXPECT_EQ(outputs.left_mps, 1.0) << "a global of its file";
  EXPECT_EQ(outputs.right_mps, 1.0) << "a global of a module beside it";
}

TEST_F(PythonController, IsGivenAllInputsAndGivesAllOutputs) {
  const auto document = with("values", "weights = [0.5, 3]\nis_on = true\n");
  const auto controller = Controllers{document}.make(load_config(document, 2));
  caravan::Inputs inputs = inputs_at(1);
  inputs.sensors.sonar_age_s[15] = 0.25;
  inputs.sensors.position = {1.5, -2.5};
  inputs.sensors.yaw_rad = 0.75;
  inputs.sensors.left_wheel_rad = 11.0;
  inputs.sensors.right_wheel_rad = 12.0;
  inputs.sensors.holding = true;
  inputs.heard.push_back({.channel = 2, .bytes = {104, 105}, .signal_strength_dbm = -40.0});
  inputs.destination = caravan::Position{8.0, 9.0};
  const caravan::Outputs outputs = controller->step(inputs);
  EXPECT_EQ(outputs.left_mps, 3.0);
  EXPECT_EQ(outputs.right_mps, 0.5);
  EXPECT_TRUE(outputs.gripper_closed);
  EXPECT_EQ(outputs.tuned_channel, 3U);
  ASSERT_EQ(outputs.frames.size(), 1U);
  EXPECT_EQ(outputs.frames[0].channel, 1U);
  EXPECT_THAT(outputs.frames[0].bytes, ElementsAre(0, 255));
  ASSERT_TRUE(outputs.report);
  EXPECT_EQ(outputs.report->mode, Mode::kTransport);
  EXPECT_EQ(outputs.report->activity, Activity::kAvoiding);
  EXPECT_EQ(outputs.report->origin, Origin::kFound);
  EXPECT_TRUE(outputs.report->towards_destination);
  EXPECT_EQ(outputs.report->trips, 2U);
  EXPECT_EQ(outputs.report->malformed_frames, 7U);
  ASSERT_TRUE(outputs.report->path);
  EXPECT_EQ(outputs.report->path->at(0).y_m, 2.0);
  ASSERT_EQ(outputs.report->exchanges.size(), 1U);
  EXPECT_EQ(outputs.report->exchanges[0].partner, 4U);
  EXPECT_EQ(outputs.report->exchanges[0].ended, Time{6});
  ASSERT_EQ(outputs.report->events.size(), 1U);
  EXPECT_THAT(outputs.report->events[0].detail, StartsWith("[2, 7, "));
  EXPECT_THAT(
      outputs.report->events[0].detail,
      HasSubstr("32000000, 0.032, 3.0, 0.25, 1.5, -2.5, 0.75, 11.0, 12.0, True, Position(x_m=8.0, y_m=9.0), "
                "[(2, b'hi', -40.0)], [0.5, 3.0], True]"));
  EXPECT_EQ(controller->step(inputs_at(5)).left_mps, 3.0) << "an array that it has kept does not change";
}

TEST_F(PythonController, MayBeCalledFromAnyThread) {
  const auto document = with("chatterer");
  const Controllers controllers{document};
  const Config config = load_config(document, 1);
  const auto expected = controllers.make(config);
  std::vector<std::unique_ptr<Controller>> others;
  for (int i = 0; i < 4; ++i) others.push_back(controllers.make(config));
  std::vector<std::vector<double>> speeds(others.size());
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < others.size(); ++i) {
      threads.emplace_back([&, i] {
        for (int step = 0; step < 200; ++step) speeds[i].push_back(others[i]->step(inputs_at(step)).left_mps);
      });
    }
  }
  for (std::size_t step = 0; step < 200; ++step) {
    const double speed = expected->step(inputs_at(static_cast<int>(step))).left_mps;
    for (const auto& one : speeds) ASSERT_EQ(one[step], speed) << step;
  }
}

}  // namespace
}  // namespace caravan::agent
