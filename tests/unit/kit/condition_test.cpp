// SPDX-License-Identifier: Apache-2.0
#include <caravan/condition.hpp>

#include "deploy/control/words.hpp"
#include "deploy/kit/tally.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace caravan::deploy {
namespace {

using ::testing::HasSubstr;

Seen some() {
  Seen seen;
  seen.state = "running";
  seen.step = 120;
  seen.members = 3;
  seen.gone = {"robot 2", "radio"};
  seen.robots[1] = {.has_reported = true, .mode = "explore", .activity = "driving", .exchanges = 2};
  seen.robots[3].x_m = 3.0;
  seen.robots[3].y_m = 4.0;
  seen.processes["robot 2"] = {"ended", 137, ""};
  return seen;
}

bool holds(const std::string& text) { return Condition{text}.holds(some()); }

TEST(Condition, ComparesNumbersWordsAndLists) {
  EXPECT_TRUE(holds("step > 119"));
  EXPECT_FALSE(holds("step > 120"));
  EXPECT_TRUE(holds("step >= 120 and step <= 120"));
  EXPECT_TRUE(holds("members is 3"));
  EXPECT_TRUE(holds("members is not 4"));
  EXPECT_TRUE(holds("state is running"));
  EXPECT_FALSE(holds("state is not running"));
  EXPECT_TRUE(holds("gone has \"robot 2\""));
  EXPECT_FALSE(holds("gone has robot"));
  EXPECT_TRUE(holds("gone lacks \"robot 1\" and hung is none"));
  EXPECT_FALSE(holds("gone is none"));
}

TEST(Condition, AllPartsMustHold) {
  EXPECT_FALSE(holds("members is 3 and step > 120"));
  EXPECT_FALSE(holds("step > 120 and members is 3"));
}

TEST(Condition, AsksRobotsAndProcesses) {
  EXPECT_TRUE(holds("mode 1 is explore and activity 1 is driving and exchanges 1 >= 2"));
  EXPECT_TRUE(holds("distance 1 3 is 5"));
  EXPECT_TRUE(holds("process robot 2 is ended and exit robot 2 is 137"));
  EXPECT_TRUE(holds("process radio is absent"));
  EXPECT_TRUE(holds("disturbed is no"));
}

TEST(Condition, WhatIsNotKnownYetFulfilsNothing) {
  EXPECT_FALSE(holds("mode 3 is explore")) << "it has not reported";
  EXPECT_FALSE(holds("mode 3 is not explore"));
  EXPECT_FALSE(holds("trips 9 < 1"));
  EXPECT_FALSE(holds("exit world is 0"));
}

TEST(Condition, ReadsALog) {
  const auto file = std::filesystem::temp_directory_path() / "caravan_condition_test.log";
  std::ofstream{file} << "first line\nrobot lost robot=2\n";
  Seen seen;
  seen.processes["world"] = {"running", {}, file.string()};
  EXPECT_TRUE(Condition{"log world has \"robot lost robot=2\""}.holds(seen));
  EXPECT_TRUE(Condition{"log world lacks \"robot lost robot=3\""}.holds(seen));
  std::filesystem::remove(file);
}

TEST(Condition, AsksTheTallyForMetricsAndEvents) {
  const auto tally = std::make_shared<Tally>(experiment::RunFacts{
      .scenario = {}, .engine = {}, .mode = {}, .robots = 2, .items = 5, .max_time = {}});
  experiment::Observation step;
  step.members = {1, 2};
  step.contacts = {{1, 2}, {2, 0}};
  step.items_delivered = 1;
  step.item_events = {{experiment::ItemEvent::Kind::kDelivery, 2}};
  tally->observe(step);
  step.stamp = std::chrono::milliseconds{32};
  step.contacts = {{2, 0}};
  step.item_events = {};
  tally->observe(step);
  tally->note(experiment::RunEnd{
      .digest = "abc", .disturbed = true, .failure = {}, .time_split = {}, .refusals = {}, .strangers = {}});
  Seen seen;
  EXPECT_FALSE(Condition{"events contact >= 0"}.holds(seen)) << "no world was heard";
  seen.tally = tally;
  EXPECT_TRUE(Condition{"metric items_delivered is 1 and metric items 2 is 1"}.holds(seen));
  EXPECT_TRUE(Condition{"metric contacts.robot_static is 2 and metric disturbed is yes"}.holds(seen));
  EXPECT_TRUE(Condition{"metric completed is no and metric digest is abc"}.holds(seen));
  EXPECT_FALSE(Condition{"metric found_s 1 >= 0"}.holds(seen)) << "null in metrics.json";
  EXPECT_TRUE(Condition{"events contact is 3 and events contact 2 is 2 and events left is 0"}.holds(seen));
  EXPECT_TRUE(Condition{"event contact 1 has with=2 and event contact 2 is with=static"}.holds(seen));
  EXPECT_FALSE(Condition{"event left 1 lacks x"}.holds(seen)) << "there was none";
  EXPECT_EQ((Condition{"metric items 2 > 4"}.values(seen)), "metric = 1");
}

TEST(Condition, KnowsWhatARobotSendsOnlyWhenItIsOverheard) {
  Seen seen = some();
  const Condition condition{"sends 3 has ACCEPT_"};
  EXPECT_TRUE(condition.asks_for("sends"));
  EXPECT_FALSE(Condition{"step > 3"}.asks_for("sends"));
  EXPECT_FALSE(condition.holds(seen));
  seen.robots[3].sent = "WAIT_3_BUSY ACCEPT_3-1";
  EXPECT_TRUE(condition.holds(seen));
  EXPECT_FALSE(Condition{"sends 3 has ACCEPTACK_"}.holds(seen));
}

TEST(Condition, SaysWhatItSees) {
  EXPECT_EQ((Condition{"gone has x and step > 3 and mode 3 is explore"}.values(some())),
            "gone = [robot 2, radio], step = 120, mode = unknown");
}

TEST(Condition, RefusesWhatMakesNoSense) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "is missing"},
      {"luck > 3", "there is no quantity \"luck\""},
      {"step", "a comparison"},
      {"step about 3", "not a comparison"},
      {"step >", "the value"},
      {"step > many", "\"many\" is not a number"},
      {"mode is explore", "robot"},
      {"step > 3 or step < 1", "one word too many"},
      {"metric luck > 3", "\"luck\""},
      {"metric items > 3", "robot"},
      {"metric seed is 1", "\"seed\""},
      {"events Contact is 1", "lower_snake_case"},
      {"event contact is 1", "robot"},
  };
  for (const auto& [text, reason] : cases) {
    try {
      const Condition condition{text};
      ADD_FAILURE() << text << " was taken";
    } catch (const WordsError& error) {
      EXPECT_THAT(error.what(), HasSubstr(reason)) << text;
    }
  }
}

}  // namespace
}  // namespace caravan::deploy
