// SPDX-License-Identifier: Apache-2.0
#include "deploy/kit/script.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "build_paths.hpp"
#include "runtime/config/start_error.hpp"
#include "runtime/scenario/shared_tables.hpp"

namespace caravan::deploy {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class ScriptFile : public ::testing::Test {
 protected:
  ScriptFile() {
    std::string pattern = fs::temp_directory_path() / "caravan_script_XXXXXX";
    folder_ = mkdtemp(pattern.data());
  }
  ~ScriptFile() override { fs::remove_all(folder_); }

  Script load(const std::string& text, const runtime::Settings& settings = {}) {
    const fs::path file = folder_ / "script.toml";
    const fs::path small = fs::path{CARAVAN_SOURCE_DIR} / "deploy/scenarios/small.toml";
    std::ofstream{file} << "scenario = \"" << small.string() << "\"\n" << text;
    return load_script(file, settings);
  }
  std::string error_of(const std::string& text) {
    try {
      (void)load(text);
    } catch (const runtime::StartError& error) {
      return error.what();
    }
    return "none";
  }

  fs::path folder_;
};

TEST_F(ScriptFile, IsLaidOverTheScenarioBeforeTheSettingsOfTheCommandLine) {
  const runtime::Settings settings = {runtime::read_setting("robots.count=6", "--set")};
  const Script script =
      load("[changes]\nrobots.count = 2\nexperiment.items = 9\n[[step]]\ndo = 'kill robot 6'\n", settings);

  const runtime::TomlDocument scenario = scenario_of(script);
  EXPECT_EQ(runtime::read_robots(scenario).count, 6U);
  EXPECT_EQ(runtime::read_experiment(scenario).items, 9U);
  const auto wrong = [this] {
    (void)load("[[step]]\ndo = 'go'\n", {runtime::read_setting("robots.count=0", "--set")});
  };
  EXPECT_THAT(wrong, ::testing::ThrowsMessage<runtime::StartError>(
                         ::testing::StartsWith("--set robots.count=0: must be")));
}

TEST_F(ScriptFile, IsReadWhole) {
  const Script script = load(R"(
name = "a night shift"
hold_start = true
lease_s = 1.0
agents_per_process = 2
[changes.experiment]
items = 9
[[step]]
do = 'start all; go; teleport 1 2 3'
expect = "step > 3"
within_s = 2.5
[[step]]
name = "later"
at_s = 3.2
when = "members is 4"
)");
  EXPECT_EQ(script.name, "a night shift");
  EXPECT_TRUE(script.hold_start);
  EXPECT_EQ(script.lease_s, 1.0);
  EXPECT_EQ(script.agents_per_process, 2U);
  EXPECT_THAT(script.changes, HasSubstr("items = 9"));
  ASSERT_EQ(script.steps.size(), 2U);
  EXPECT_THAT(script.steps[0].actions, ElementsAre("start all", " go", " teleport 1 2 3"));
  EXPECT_EQ(script.steps[0].expectation->text(), "step > 3");
  EXPECT_EQ(script.steps[0].within, std::chrono::milliseconds{2500});
  EXPECT_EQ(script.steps[1].name, "later");
  EXPECT_EQ(script.steps[1].at_step, 100U) << "3.2 s in steps of 0.032 s";
  EXPECT_EQ(script.steps[1].when->text(), "members is 4");
}

TEST_F(ScriptFile, IsRefusedBeforeAnythingStarts) {
  EXPECT_THAT(error_of("[[step]]\ndo = \"kill robot 9\"\n"),
              HasSubstr("script.toml:3: step.do: there is no robot 9"));
  EXPECT_THAT(error_of("[[step]]\nexpect = \"luck > 3\"\n"), HasSubstr("there is no quantity \"luck\""));
  EXPECT_THAT(error_of("[[step]]\nwait_s = 3\n"), HasSubstr("unknown key"));
  EXPECT_THAT(error_of("[[step]]\nat_s = 3.0\nat_step = 4\n"), HasSubstr("not both"));
  EXPECT_THAT(error_of("colour = 3\n[[step]]\n"), HasSubstr("colour: unknown key"));
  EXPECT_THAT(error_of("agents_per_process = 0\n[[step]]\n"), HasSubstr("agents_per_process"));
  EXPECT_THAT(error_of("hold_start = true\n"), HasSubstr("at least one [[step]]"));
  EXPECT_THAT(error_of("[changes.robots]\ncount = -3\n[[step]]\n"), HasSubstr("robots.count"));
}

TEST(ShippedScripts, AreGood) {
  int scripts = 0;
  for (const auto& entry : fs::directory_iterator{CARAVAN_SOURCE_DIR "/deploy/scripts"}) {
    EXPECT_NO_THROW((void)load_script(entry.path())) << entry.path();
    ++scripts;
  }
  EXPECT_GT(scripts, 0);
}

}  // namespace
}  // namespace caravan::deploy
