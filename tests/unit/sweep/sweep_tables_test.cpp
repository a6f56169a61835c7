// SPDX-License-Identifier: Apache-2.0
#include "experiment/sweep/sweep_tables.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "experiment/sweep/quantities.hpp"
#include "tests/unit/sweep/folders.hpp"

namespace caravan::experiment {
namespace {

using testing::HasSubstr;

RunRow done(double sim_time_s, double wall_time_s = 0.0) {
  RunEnd end;
  end.wall_time_s = wall_time_s;
  const auto metrics = nlohmann::json::parse(metrics_text(sim_time_s, true, end));
  return {.state = RunState::kDone, .digest = "00", .values = values_in(metrics)};
}

const SweepPlan kPlan = plan_of({"none", "full"}, {1, 2, 3});

std::vector<RunRow> rows() {
  std::vector<RunRow> all(6);
  all[0] = done(60.0);
  all[1] = {.state = RunState::kFailed, .reason = "killed, \"hard\""};
  all[2] = done(100.0);
  return all;
}

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(SweepTables, HaveARowForEachRunWithFailedOnesMarked) {
  const std::string text = runs_csv(kPlan, rows());

  EXPECT_EQ(lines(text), 7U);
  EXPECT_THAT(text, HasSubstr("index,mode,seed,state,reason,digest,completed,"));
  EXPECT_THAT(text, HasSubstr("\n0,none,1,done,,00,1,0,1,60,"));
  EXPECT_THAT(text, HasSubstr("\n1,none,2,failed,\"killed, \"\"hard\"\"\",,,"));
  EXPECT_THAT(text, HasSubstr("\n5,full,3,pending,,,"));
}

TEST(SweepTables, HaveAColumnForEachAxis) {
  const SweepPlan grid = with_axis(plan_of({"none"}, {1, 2}));
  const std::vector<RunRow> rows(4);

  const std::string text = runs_csv(grid, rows);
  EXPECT_THAT(text, HasSubstr("index,mode,seed,radio.range_m,state,reason,digest,completed,"));
  EXPECT_THAT(text, HasSubstr("\n1,none,2,2,pending,,,"));
  EXPECT_THAT(text, HasSubstr("\n2,none,1,4,pending,,,"));
  const auto json = nlohmann::json::parse(sweep_json(grid, rows, SweepState::kRunning));
  EXPECT_EQ(json["axes"], (nlohmann::json{"radio.range_m"}));
  EXPECT_EQ(json["runs"][2]["folder"], "radio.range_m=4/none/seed_1");
  EXPECT_EQ(json["runs"][2]["values"], (nlohmann::json{"4"}));
  EXPECT_EQ(json["runs"][2]["point"], "radio.range_m=4");
}

TEST(SweepTables, SummariseEachModeAndQuantityOverTheRunsThatAreDone) {
  const std::string text = summary_csv(kPlan, rows());

  EXPECT_THAT(text, HasSubstr("mode,quantity,n,minimum,lower_quartile,median,upper_quartile,maximum\n"));
  EXPECT_THAT(text, HasSubstr("\nnone,sim_time_s,2,60,70,80,90,100\n"));
  EXPECT_THAT(text, HasSubstr("\nnone,path_length_mean_m,2,10,10,10,10,10\n"));
  EXPECT_THAT(text, HasSubstr("\nfull,sim_time_s,0,,,,,\n"));
}

TEST(SweepTables, SummariseNoWallTimeSoThatTheSameSweepGivesTheSameText) {
  std::vector<RunRow> quick(6);
  std::vector<RunRow> slow(6);
  quick[0] = done(60.0, 1.0);
  slow[0] = done(60.0, 2.0);

  EXPECT_NE(runs_csv(kPlan, quick), runs_csv(kPlan, slow));
  EXPECT_EQ(summary_csv(kPlan, quick), summary_csv(kPlan, slow));
}

TEST(SweepTables, TellTheStateOfEveryRunInJson) {
  const auto json = nlohmann::json::parse(sweep_json(kPlan, rows(), SweepState::kUnfinished));

  EXPECT_EQ(json["scenario"], "course");
  EXPECT_EQ(json["state"], "unfinished");
  EXPECT_EQ(json["modes"], (nlohmann::json{"none", "full"}));
  EXPECT_EQ(json["seeds"], (nlohmann::json{1, 2, 3}));
  ASSERT_EQ(json["runs"].size(), 6U);
  EXPECT_EQ(json["runs"][1]["state"], "failed");
  EXPECT_EQ(json["runs"][1]["reason"], "killed, \"hard\"");
  EXPECT_EQ(json["runs"][4]["folder"], "full/seed_2");
  EXPECT_EQ(json["runs"][4]["state"], "pending");
}

TEST(SweepTables, StayReadableWhateverBytesAReasonHas) {
  std::vector<RunRow> all(6);
  all[0] = {.state = RunState::kFailed, .reason = "\xff\xfe"};
  EXPECT_TRUE(nlohmann::json::accept(sweep_json(kPlan, all, SweepState::kComplete)));
}

TEST(SweepTables, ShowFailuresOnTheTerminal) {
  const std::string text = sweep_table(kPlan, rows());
  EXPECT_THAT(text, HasSubstr("failed: mode none seed 2: killed, \"hard\"\n"));
  EXPECT_THAT(text, HasSubstr("1.3 (1.0 to 1.7)"));
}

}  // namespace
}  // namespace caravan::experiment
