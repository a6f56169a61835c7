// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <optional>

#include "tests/system/support/process.hpp"

namespace caravan {
namespace {

namespace fs = std::filesystem;
using test::eventually;
using test::kPatience;
using test::Process;
using test::read_file;

const fs::path kSmall = test::scenario("small.toml");

nlohmann::json metrics_of(const fs::path& folder) {
  return nlohmann::json::parse(read_file(folder / "metrics.json"));
}

/// How far metrics.json goes, s; 0 before it exists.
double known_s(const fs::path& folder) {
  return fs::exists(folder / "metrics.json") ? metrics_of(folder)["sim_time_s"].get<double>() : 0.0;
}

/// How a run with this command line ends, and its output. Its log lies outside the folder that it fills.
struct Ending {
  std::optional<int> exit_code;
  std::string said;
};
Ending ending_of(const test::ScratchFolder& folder, const std::vector<std::string>& words) {
  Process process{words, folder / "log"};
  const auto code = process.wait(kPatience);
  return {code, process.output()};
}

std::vector<std::string> embedded(const fs::path& scenario, const fs::path& out,
                                  const std::vector<std::string>& more) {
  std::vector<std::string> words = {"caravan", "run", scenario, "--engine", "embedded", "--out", out};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// A run of the small scenario that continues until it is stopped.
std::vector<std::string> endless(const fs::path& out) {
  return embedded(kSmall, out, {"--items", "0", "--max-time", "100000000", "--quiet"});
}

TEST(EmbeddedRun, TheEffectiveScenarioRepeatsTheRunBitForBit) {
  const test::ScratchFolder folder;
  const fs::path one = folder / "one";
  const fs::path again = folder / "again";
  const fs::path other = folder / "other";
  const std::vector<std::string> changes = {"--items", "0",          "--robots", "3",      "--seed",
                                            "5",       "--max-time", "20",       "--mode", "partial"};

  EXPECT_EQ(ending_of(folder, embedded(kSmall, one, changes)).exit_code, 0);
  EXPECT_EQ(ending_of(folder, embedded(one / "scenario.toml", again, {})).exit_code, 0);
  EXPECT_EQ(ending_of(folder, embedded(one / "scenario.toml", other, {"--seed", "6"})).exit_code, 0);

  const auto first = metrics_of(one);
  EXPECT_EQ(first["scenario"], "small");
  EXPECT_EQ(first["mode"], "partial");
  EXPECT_EQ(first["robots"], 3);
  EXPECT_EQ(first["per_robot"].size(), 3U);
  EXPECT_NEAR(first["sim_time_s"], 20.0, 0.05);
  EXPECT_THAT(first["digest"].get<std::string>(), testing::MatchesRegex("[0-9a-f]{16}"));
  EXPECT_EQ(first["digest"], metrics_of(again)["digest"]);
  EXPECT_NE(first["digest"], metrics_of(other)["digest"]);
  EXPECT_EQ(read_file(one / "tracks.csv"), read_file(again / "tracks.csv"));
  EXPECT_EQ(read_file(one / "scenario.toml"), read_file(again / "scenario.toml"));
}

TEST(EmbeddedRun, EndsWithOneWhenTheTimeRunsOutAndSaysSo) {
  const test::ScratchFolder folder;
  const fs::path out = folder / "out";

  const Ending ending = ending_of(folder, embedded(kSmall, out, {"--max-time", "2"}));

  EXPECT_EQ(ending.exit_code, 1);
  EXPECT_THAT(ending.said, testing::HasSubstr("time limit reached"));
  EXPECT_THAT(ending.said, testing::HasSubstr(out.string()));
  EXPECT_EQ(metrics_of(out)["completed"], false);
}

TEST(EmbeddedRun, QuietSaysNothing) {
  const test::ScratchFolder folder;

  const Ending ending = ending_of(folder, embedded(kSmall, folder / "out", {"--max-time", "2", "--quiet"}));

  EXPECT_EQ(ending.said, "");
}

TEST(EmbeddedRun, AnInterruptClosesTheRecordsAndEndsWithOneHundredAndThirty) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    const test::ScratchFolder folder;
    const fs::path out = folder / "out";
    Process process{endless(out), folder / "log"};
    ASSERT_TRUE(eventually([&] { return known_s(out) > 0.0; }, kPatience));
    process.signal(number);

    EXPECT_EQ(process.wait(kPatience), 130);
    const auto metrics = metrics_of(out);
    EXPECT_EQ(metrics["ended"], true);
    EXPECT_EQ(metrics["interrupted"], true);
    EXPECT_EQ(metrics["completed"], false);
    EXPECT_GT(metrics["sim_time_s"], 0.0);
  }
}

TEST(EmbeddedRun, AKillLosesNoRecordOlderThanASecond) {
  const test::ScratchFolder folder;
  const fs::path out = folder / "out";
  Process process{endless(out), folder / "log"};
  ASSERT_TRUE(eventually([&] { return known_s(out) > 1.0; }, kPatience));
  const double known = known_s(out);
  process.signal(SIGKILL);

  EXPECT_EQ(process.wait(kPatience), 128 + SIGKILL);
  EXPECT_EQ(metrics_of(out)["ended"], false);
  // tracks.csv covers the time in metrics.json: it has the rows of the last whole second.
  const std::string second = "\n" + std::to_string(static_cast<long>(known) - 1) + ".";
  EXPECT_THAT(read_file(out / "tracks.csv"), testing::HasSubstr(second));
}

}  // namespace
}  // namespace caravan
