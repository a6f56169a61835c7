// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "build_paths.hpp"
#include "robot_agent/config/agent_config.hpp"

namespace caravan::agent {
namespace {

using runtime::StartError;
using runtime::TomlDocument;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(AgentConfig, EveryShippedScenarioIsReadForItsFirstRobot) {
  for (const char* name : {"paper", "paper_code", "small", "scaling", "one_robot"}) {
    SCOPED_TRACE(name);
    const auto file = std::string{CARAVAN_SOURCE_DIR "/deploy/scenarios/"} + name + ".toml";
    EXPECT_NO_THROW((void)load_config(TomlDocument::load(file), 1));
  }
}

TEST(AgentConfig, ThePapersTextAndItsCodeDifferAsTheFactsSay) {
  const std::string folder = CARAVAN_SOURCE_DIR "/deploy/scenarios/";
  const Config text = load_config(TomlDocument::load(folder + "paper.toml"), 3);
  const Config code = load_config(TomlDocument::load(folder + "paper_code.toml"), 3);
  EXPECT_EQ(text.id, RobotId{3});
  EXPECT_DOUBLE_EQ(text.recording.spacing_m, 1.0);
  EXPECT_DOUBLE_EQ(code.recording.spacing_m, 0.3);
  EXPECT_DOUBLE_EQ(text.smoothing.vision_radius_m, 6.0);
  EXPECT_DOUBLE_EQ(code.smoothing.vision_radius_m, 4.0);
  EXPECT_DOUBLE_EQ(text.exploration.detection_radius_m, 4.0);
  EXPECT_DOUBLE_EQ(code.exploration.detection_radius_m, 2.0);
  EXPECT_EQ(text.wait.period, std::chrono::nanoseconds{0});
  EXPECT_EQ(code.wait.period, std::chrono::seconds{1});
  EXPECT_EQ(code.sharing.accept_period, std::chrono::milliseconds{500});
}

TEST(AgentConfig, ARobotThatTheScenarioDoesNotHaveIsRefusedByName) {
  const auto scenario = TomlDocument::parse("[robots]\ncount = 4\n", "a.toml");
  EXPECT_THAT([&] { (void)load_config(scenario, 0); }, ThrowsMessage<StartError>(HasSubstr("robot")));
  EXPECT_THAT([&] { (void)load_config(scenario, 5); }, ThrowsMessage<StartError>(HasSubstr("1 to 4")));
  EXPECT_NO_THROW((void)load_config(scenario, 4));
}

TEST(AgentConfig, TrafficAndStopsToExchangeCanBeSwitchedOff) {
  const auto scenario =
      TomlDocument::parse("[robots]\nsolid = false\n[algorithm]\nstop_to_exchange = false\n", "a.toml");
  EXPECT_FALSE(load_config(scenario, 1).robots_are_solid);
  EXPECT_FALSE(load_config(scenario, 1).sharing.stop_to_exchange);
  EXPECT_TRUE(Config{}.robots_are_solid);
  EXPECT_TRUE(Config{}.sharing.stop_to_exchange);
}

TEST(AgentConfig, EveryNumberIsBounded) {
  for (const char* key : {"exploration_step_m", "exploration_spread_rad",
                          "cruise_mps",         "slow_mps",
                          "slow_below_m",       "too_close_m",
                          "meeting_m",          "keep_clear_m",
                          "arrival_radius_m",   "gripper_patience_s",
                          "point_spacing_m",    "vision_radius_m",
                          "detection_radius_m", "corridor_m",
                          "shortcut_gain_m",    "shortcut_pause_s",
                          "sharing_starts_s",   "recontact_after_s",
                          "wait_period_s",      "accept_period_s",
                          "session_timer_s"}) {
    SCOPED_TRACE(key);
    const auto scenario = TomlDocument::parse("[algorithm]\n" + std::string{key} + " = 1e150\n", "a.toml");
    EXPECT_THAT([&] { (void)load_config(scenario, 1); },
                ThrowsMessage<StartError>(HasSubstr("a.toml:2: algorithm." + std::string{key} + ": must ")));
  }
}

struct Refused {
  const char* text;
  const char* message;
};
class AgentConfigRefuses : public testing::TestWithParam<Refused> {};

TEST_P(AgentConfigRefuses, WithFileLineAndKey) {
  const auto scenario = TomlDocument::parse(GetParam().text, "a.toml");
  EXPECT_THAT([&] { (void)load_config(scenario, 1); },
              ThrowsMessage<StartError>(HasSubstr(GetParam().message)));
}

INSTANTIATE_TEST_SUITE_P(
    Lines, AgentConfigRefuses,
    testing::Values(
        Refused{"[algorithm]\nspeed = 1.0\n", "a.toml:2: algorithm.speed: unknown key"},
        Refused{"[algorithm]\nmode = \"some\"\n", "a.toml:2: algorithm.mode: must be one of"},
        Refused{"[algorithm]\ncruise_mps = \"fast\"\n", "a.toml:2: algorithm.cruise_mps: must be a number"},
        Refused{"[algorithm]\nvision_radius_m = -6.0\n",
                "a.toml:2: algorithm.vision_radius_m: must be above 0"},
        Refused{"[algorithm]\ncruise_mps = 1.7\n", "a.toml:2: algorithm.cruise_mps: must not exceed"},
        Refused{"[algorithm]\narrival_radius_m = 1.6\n", "algorithm.arrival_radius_m: must not exceed"},
        Refused{"[algorithm]\ntoo_close_m = 1.1\n", "algorithm.too_close_m: must not exceed"},
        Refused{"[algorithm]\nkeep_clear_m = -0.1\n", "a.toml:2: algorithm.keep_clear_m: must"},
        Refused{"[algorithm]\nwait_tells_place = 1\n", "a.toml:2: algorithm.wait_tells_place: must be"},
        Refused{"[algorithm]\ncorridor_m = 0.3\n", "algorithm.corridor_m: must not be less"}));

TEST(AgentConfig, TheWorldIsNotRead) {
  const auto scenario = TomlDocument::parse("[world]\nthis_is_nobodys_business = true\n", "a.toml");
  EXPECT_NO_THROW((void)load_config(scenario, 1));
}

}  // namespace
}  // namespace caravan::agent
