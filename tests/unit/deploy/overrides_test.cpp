// SPDX-License-Identifier: Apache-2.0
#include "deploy/cli/overrides.hpp"

#include <gmock/gmock.h>

#include "runtime/scenario/name.hpp"
#include "runtime/scenario/shared_tables.hpp"

namespace caravan::deploy {
namespace {

using runtime::TomlDocument;

TomlDocument applied(const std::string& text, const Overrides& overrides) {
  return TomlDocument::parse(effective_text(TomlDocument::parse(text, "course.toml"), overrides),
                             "effective");
}

TEST(Overrides, ReplaceTheKeysThatTheyStandFor) {
  Overrides overrides;
  overrides.mode = "none";
  overrides.seed = 9223372036854775807ULL;
  overrides.robots = 3;
  overrides.items = 0;
  overrides.max_time_s = 90.0;
  overrides.pacing = "realtime";

  const TomlDocument scenario =
      applied("seed = 4\n[robots]\ncount = 15\n[algorithm]\nmode = \"full\"\n", overrides);

  EXPECT_EQ(runtime::read_seed(scenario), 9223372036854775807ULL);
  EXPECT_EQ(runtime::read_robots(scenario).count, 3U);
  const runtime::ExperimentTable experiment = runtime::read_experiment(scenario);
  EXPECT_EQ(experiment.items, 0U);
  EXPECT_EQ(experiment.max_time_s, 90.0);
  EXPECT_EQ(experiment.pacing, runtime::Pacing::kRealtime);
  std::string mode;
  scenario.table("algorithm").read("mode", mode);
  EXPECT_EQ(mode, "none");
}

TEST(Overrides, LeaveEverythingElseAsItIsToTheLastBit) {
  const std::string text =
      "[robots]\nsource_m = [0.1, 0.30000000000000004]\ngps_noise_m = 1e-300\n"
      "[robots.sonar]\nreflection_rad = 0.39269908169872414\n";
  Overrides overrides;
  overrides.robots = 2;

  const runtime::RobotsTable robots = runtime::read_robots(applied(text, overrides));

  EXPECT_EQ(robots.source_m, (std::array<double, 2>{0.1, 0.30000000000000004}));
  EXPECT_EQ(robots.gps_noise_m, 1e-300);
  EXPECT_EQ(robots.sonar.reflection_rad, 0.39269908169872414);
}

TEST(Overrides, AreAppliedAgainToTheirOwnResultWithoutChange) {
  Overrides overrides;
  overrides.seed = 5;
  const std::string once = effective_text(TomlDocument::parse("seed = 1", "course.toml"), overrides);

  EXPECT_EQ(effective_text(TomlDocument::parse(once, "scenario.toml"), {}), once);
}

TEST(Overrides, AScenarioWithoutNameIsNamedAfterItsFile) {
  EXPECT_EQ(name_of(TomlDocument::parse("", "some/where/course.toml")), "course");
  EXPECT_EQ(name_of(TomlDocument::parse("name = \"loop\"", "some/where/course.toml")), "loop");
  EXPECT_EQ(name_of(applied("", {})), "course");
}

TEST(Settings, AreReadFromTheCommandLine) {
  const runtime::Settings settings = read_settings({"radio.range_m=4", "controller.rate=2"}, {});
  ASSERT_EQ(settings.size(), 2U);
  EXPECT_EQ(settings[1].key, "controller.rate");
  EXPECT_EQ(settings[1].value, "2");
}

TEST(Settings, AreRefusedTwiceAndBesideTheOptionForTheSameKey) {
  using testing::StartsWith;
  using testing::ThrowsMessage;
  EXPECT_THAT(
      [] {
        (void)read_settings({"a.b=1", "a.b=2"}, {});
      },
      ThrowsMessage<runtime::StartError>(StartsWith("--set a.b=2: is set twice")));
  Overrides overrides;
  overrides.robots = 4;
  overrides.controller = "paper";
  EXPECT_THAT([&] { (void)read_settings({"robots.count=5"}, overrides); },
              ThrowsMessage<runtime::StartError>(StartsWith("--set robots.count=5: --robots sets it, too")));
  EXPECT_THAT([&] { (void)read_settings({"controller.library=x.so"}, overrides); },
              ThrowsMessage<runtime::StartError>(StartsWith("--set controller.library=x.so: --controller")));
  EXPECT_NO_THROW((void)read_settings({"experiment.items=5"}, overrides));
}

TEST(Name, OfAScenarioIsLettersDigitsDotsDashesAndUnderlinesUpTo64) {
  const auto named = [](const std::string& name) {
    return name_of(TomlDocument::parse("name = " + name + "\n", "course.toml"));
  };
  for (const std::string good : {"paper", "Paper_2.1-x", "...", "a", "a-"})
    EXPECT_EQ(named("'" + good + "'"), good);
  EXPECT_EQ(named("'" + std::string(64, 'x') + "'"), std::string(64, 'x'));
  for (const std::string& bad :
       {std::string{"''"}, std::string{"'.'"}, std::string{"'..'"}, std::string{"'-'"},
        std::string{"'--help'"}, std::string{"'a/b'"}, std::string{"'../../x'"}, std::string{"'a b'"},
        std::string{R"("a\nb")"}, std::string{R"("a\u0000b")"}, std::string{"'\u00e9'"},
        "'" + std::string(65, 'x') + "'"}) {
    EXPECT_THAT([&] { (void)named(bad); }, testing::ThrowsMessage<runtime::StartError>(
                                               testing::StartsWith("course.toml:1: name: must be")))
        << bad;
  }
}

TEST(Name, ThatTheFileGivesIsMadeOne) {
  const auto of_file = [](const std::string& file) { return name_of(TomlDocument::parse("", file)); };
  EXPECT_EQ(of_file("/home/me/my course\n2.toml"), "my_course_2");
  EXPECT_EQ(of_file("..toml"), "scenario");
  EXPECT_EQ(of_file("--help.toml"), "scenario");
  EXPECT_EQ(of_file(std::string(200, 'x') + ".toml"), std::string(64, 'x'));
}

}  // namespace
}  // namespace caravan::deploy
