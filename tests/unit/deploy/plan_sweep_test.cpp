// SPDX-License-Identifier: Apache-2.0
#include "deploy/cli/plan_sweep.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>

#include "build_paths.hpp"
#include "deploy/cli/overrides.hpp"
#include "runtime/scenario/shared_tables.hpp"

namespace caravan::deploy {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

SweepCommand small(std::vector<std::string> sets) {
  SweepCommand command;
  command.scenario = fs::path{CARAVAN_SOURCE_DIR} / "deploy/scenarios/small.toml";
  command.seeds = "1-2";
  command.sets = std::move(sets);
  return command;
}

std::string refusal(const SweepCommand& command) {
  try {
    (void)plan_sweep(command);
  } catch (const runtime::StartError& error) {
    return error.what();
  }
  return "none";
}

TEST(SweepPlan, WithoutAxesHasAllModesAndNoPoints) {
  const auto plan = plan_sweep(small({}));
  EXPECT_THAT(plan.modes, ElementsAre("none", "partial", "full"));
  EXPECT_THAT(plan.runs, SizeIs(6));
  EXPECT_THAT(plan.axes, SizeIs(0));
  EXPECT_EQ(folder_of(plan.runs[1]), "none/seed_2");
}

TEST(SweepPlan, OfAControllerThatIsNotThePapersHasTheScenariosModeAndTheHashOfItsFile) {
  const fs::path controller = fs::path{CARAVAN_BIN_DIR}.parent_path() / "controllers/braitenberg.so";
  SweepCommand command = small({});
  command.overrides.controller = controller;
  const auto plan = plan_sweep(command);
  EXPECT_THAT(plan.modes, ElementsAre("full"));
  ASSERT_THAT(plan.controllers, SizeIs(1));
  EXPECT_EQ(plan.controllers[0].file, controller.lexically_normal());
  EXPECT_THAT(plan.controllers[0].sha256, SizeIs(64));
  ASSERT_THAT(plan.runs, SizeIs(2));
  EXPECT_EQ(plan.runs[1].controller_sha256, plan.controllers[0].sha256);

  command.modes = "none,full";
  EXPECT_THAT(plan_sweep(command).modes, ElementsAre("none", "full")) << "on demand";
  EXPECT_THAT(plan_sweep(small({})).controllers, SizeIs(0));
}

TEST(SweepPlan, CrossesItsAxesAndTakesTheScenariosMode) {
  const auto plan = plan_sweep(small({"algorithm.vision_radius_m=2,4", "robots.count=2,3,4"}));
  EXPECT_THAT(plan.modes, ElementsAre("full"));
  EXPECT_THAT(plan.axes, ElementsAre("algorithm.vision_radius_m", "robots.count"));
  ASSERT_THAT(plan.runs, SizeIs(12));
  EXPECT_THAT(plan.runs[7].values, ElementsAre("4", "2"));
  EXPECT_EQ(folder_of(plan.runs[7]), "algorithm.vision_radius_m=4,robots.count=2/full/seed_2");
  const auto scenario = runtime::TomlDocument::parse(plan.runs[7].scenario_text, "run");
  EXPECT_EQ(runtime::read_robots(scenario).count, 2U);
  EXPECT_EQ(runtime::read_seed(scenario), 2U);
}

TEST(SweepPlan, GivesEachRunTheScenarioThatTheSameSettingsGiveARun) {
  const auto plan = plan_sweep(small({"algorithm.vision_radius_m=2", "controller.library=paper"}));
  runtime::Settings settings = read_settings({"algorithm.vision_radius_m=2", "controller.library=paper"}, {});
  Overrides one;
  one.mode = "full";
  one.seed = 1;
  const auto started = runtime::TomlDocument::parse(plan.scenario_text, "out/scenario.toml", settings);
  EXPECT_EQ(effective_text(started, one), plan.runs[0].scenario_text);
}

TEST(SweepPlan, NamesTheValueThatItRefuses) {
  EXPECT_THAT(refusal(small({"algorithm.vision_radius_m=2,-1"})),
              StartsWith("--set algorithm.vision_radius_m=-1: must be"));
  EXPECT_THAT(refusal(small({"algorithm.vision=2"})), StartsWith("--set algorithm.vision=2: unknown key"));
  EXPECT_THAT(refusal(small({"algorithm.vision_radius_m="})), HasSubstr("has no value"));
  EXPECT_THAT(refusal(small({"robots.count=2,9000"})),
              StartsWith("robots.count=9000: robots.count: the arena is full"));
  EXPECT_THAT(refusal(small({"controller.rate=2"})), StartsWith("--set controller.rate=2: unknown key"));
}

TEST(SweepPlan, LeavesModesAndSeedsToTheirOptions) {
  EXPECT_THAT(refusal(small({"seed=1,2"})), StartsWith("--set seed: in a sweep, --seeds sets it"));
  EXPECT_THAT(refusal(small({"algorithm.mode=full"})), HasSubstr("--modes sets it"));
  EXPECT_THAT(refusal(small({"name=a,b"})), HasSubstr("only keys of tables"));
  SweepCommand command = small({"robots.count=2"});
  command.overrides.robots = 3;
  EXPECT_THAT(refusal(command), HasSubstr("--robots sets it, too"));
}

TEST(SweepPlan, CrossesAPlanWithItsAxes) {
  const fs::path file = fs::temp_directory_path() / ("caravan_plan_" + std::to_string(getpid()) + ".toml");
  std::ofstream{file} << "design = \"rows\"\nkeys = [\"radio.range_m\"]\nrows = [[2], [-4]]\n";
  SweepCommand command = small({"robots.count=2,3"});
  command.plan = file;
  const std::string why = refusal(command);
  std::ofstream{file} << "design = \"rows\"\nkeys = [\"radio.range_m\"]\nrows = [[2], [4]]\n";
  const auto plan = plan_sweep(command);
  fs::remove(file);

  EXPECT_THAT(why, StartsWith(file.string() + ":2: radio.range_m=-4: must be"));
  EXPECT_THAT(plan.runs, SizeIs(8));
  EXPECT_THAT(plan.runs[2].values, ElementsAre("2", "3"));
}

}  // namespace
}  // namespace caravan::deploy
