// SPDX-License-Identifier: Apache-2.0
#include "experiment/sweep/sweep_folder.hpp"

#include <gmock/gmock.h>

#include <memory>

#include "experiment/metrics/text_file.hpp"
#include "experiment/sweep/sweep_tables.hpp"
#include "runtime/config/start_error.hpp"
#include "tests/unit/sweep/folders.hpp"

namespace caravan::experiment {
namespace {

class SweepFolders : public testing::Test {
 protected:
  std::unique_ptr<SweepFolder> claim(const SweepPlan& plan, Claim claim = Claim::kSweep,
                                     std::size_t task = 0) {
    return std::make_unique<SweepFolder>(folder_.path() / "out", plan, claim, loop_, task);
  }
  std::string refusal(const SweepPlan& plan, Claim kind = Claim::kSweep, std::size_t task = 0) {
    try {
      claim(plan, kind, task);
      return "";
    } catch (const runtime::StartError& error) {
      return error.what();
    }
  }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const {
    return folder_.path() / "out" / name;
  }

  Folder folder_;
  runtime::Loop loop_;
  SweepPlan plan_ = plan_of({"none", "full"}, {1, 2});
};

TEST_F(SweepFolders, KeepTheScenarioThatTheirRunsStartFrom) {
  const auto folder = claim(plan_);
  EXPECT_EQ(text_in(folder->scenario_file()), plan_.scenario_text);
}

TEST_F(SweepFolders, AreGoneOnWithAndMayGrow) {
  claim(plan_);
  write_tables(file(""), plan_, std::vector<RunRow>(4), SweepState::kRunning);

  EXPECT_EQ(refusal(plan_), "");
  EXPECT_EQ(refusal(plan_of({"none", "partial", "full"}, {1, 2, 3})), "");
}

TEST_F(SweepFolders, RefuseASweepThatLeavesOutRunsOfTheirs) {
  claim(plan_);
  write_tables(file(""), plan_, std::vector<RunRow>(4), SweepState::kComplete);

  EXPECT_THAT(refusal(plan_of({"none", "full"}, {1})), testing::HasSubstr("none 2 is not among"));
  EXPECT_THAT(refusal(plan_of({"none"}, {1, 2})), testing::HasSubstr("full 1 is not among"));
}

TEST_F(SweepFolders, RefuseASweepWithOtherAxes) {
  const SweepPlan grid = with_axis(plan_);
  claim(grid);
  write_tables(file(""), grid, std::vector<RunRow>(8), SweepState::kComplete);
  SweepPlan half = grid;
  half.runs.resize(4);

  EXPECT_EQ(refusal(grid), "");
  EXPECT_THAT(refusal(half), testing::HasSubstr("radio.range_m=4 none 1 is not among"));
  EXPECT_THAT(refusal(plan_), testing::HasSubstr("radio.range_m=2 none 1 is not among"));
  write_tables(file(""), plan_, std::vector<RunRow>(4), SweepState::kComplete);
  EXPECT_THAT(refusal(grid), testing::HasSubstr("--set or --plan: none 1 is not among"));
}

TEST_F(SweepFolders, RefuseAnotherScenarioAForeignFolderAndASingleRun) {
  claim(plan_);
  SweepPlan other = plan_;
  other.scenario_text = "name = \"other\"\n";
  EXPECT_THAT(refusal(other), testing::HasSubstr("another scenario or with other options"));
  EXPECT_THAT(refusal(other, Claim::kTask), testing::HasSubstr("another scenario or with other options"));

  write(file("metrics.json"), "{}");
  EXPECT_THAT(refusal(plan_), testing::HasSubstr("single run"));

  std::filesystem::remove(file("scenario.toml"));
  EXPECT_THAT(refusal(plan_), testing::HasSubstr("is not empty"));
}

TEST_F(SweepFolders, HoldAnyNumberOfTasksButOneSweepOnly) {
  const auto first = claim(plan_, Claim::kTask);
  const auto second = claim(plan_, Claim::kTask, 1);
  EXPECT_EQ(refusal(plan_, Claim::kSummarise), "");
  loop_.stop();  // do not wait until the folder is free
  EXPECT_THAT(refusal(plan_), testing::HasSubstr("another sweep is using it"));
}

TEST_F(SweepFolders, HoldEachTaskOnce) {
  const auto first = claim(plan_, Claim::kTask, 2);
  loop_.stop();
  EXPECT_THAT(refusal(plan_, Claim::kTask, 2), testing::HasSubstr("another start of task 2 is using it"));
  EXPECT_EQ(refusal(plan_, Claim::kTask, 3), "");
}

TEST_F(SweepFolders, AreSummarisedByNobodyWhileASweepWritesItsTables) {
  const auto sweep = claim(plan_);
  loop_.stop();
  EXPECT_THAT(refusal(plan_, Claim::kSummarise), testing::HasSubstr("another sweep is using it"));
  EXPECT_THAT(refusal(plan_, Claim::kTask), testing::HasSubstr("another sweep is using it"));
}

}  // namespace
}  // namespace caravan::experiment
