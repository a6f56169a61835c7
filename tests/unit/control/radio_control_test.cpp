// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "radio_emulator/medium/medium.hpp"
#include "radio_emulator/medium/radio_control.hpp"

namespace caravan::radio {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Kind = pure::Outcome::Kind;

/// Four robots within range of each other; each sends one frame. @return the pairs (sender, receiver) between
/// which it arrives
std::vector<std::pair<int, int>> heard_by(std::span<const LinkRule> rules, const MediumConfig& config = {},
                                          std::uint64_t step = 0) {
  const std::vector<Station> stations{{1, 0.0, 0.0}, {2, 0.5, 0.0}, {3, 1.0, 0.0}, {4, 1.5, 0.0}};
  std::vector<Transmission> transmissions;
  for (std::uint8_t robot = 1; robot <= 4; ++robot) transmissions.push_back({robot, 0, {{0, {robot}}}});
  Drops drops;
  std::vector<std::pair<int, int>> pairs;
  for (const Reception& reception : deliver(config, step, stations, transmissions, drops, rules)) {
    for (const ReceivedFrame& frame : reception.frames) pairs.emplace_back(frame.bytes[0], reception.robot);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<std::pair<int, int>> all_but(const std::vector<std::pair<int, int>>& cut) {
  std::vector<std::pair<int, int>> pairs;
  for (int from = 1; from <= 4; ++from) {
    for (int to = 1; to <= 4; ++to) {
      const std::pair<int, int> pair{from, to};
      if (from != to && std::find(cut.begin(), cut.end(), pair) == cut.end()) pairs.push_back(pair);
    }
  }
  return pairs;
}

LinkRule cut(std::vector<std::uint32_t> robots, std::vector<std::uint32_t> others = {}) {
  return {.robots = std::move(robots), .others = std::move(others), .area = {}, .loss = 1.0};
}

TEST(LinkRules, CutALinkInBothDirectionsAndNoOther) {
  EXPECT_EQ(heard_by(std::vector{cut({1}, {2})}), all_but({{1, 2}, {2, 1}}));
}

TEST(LinkRules, CutARobotOffFromEverybody) {
  EXPECT_EQ(heard_by(std::vector{cut({3})}), all_but({{3, 1}, {3, 2}, {3, 4}, {1, 3}, {2, 3}, {4, 3}}));
}

TEST(LinkRules, CutEveryLinkWithAnEndInTheArea) {
  const LinkRule rule{.robots = {}, .others = {}, .area = Area{1.5, -1.0, 9.0, 1.0}, .loss = 1.0};
  EXPECT_EQ(heard_by(std::vector{rule}), all_but({{4, 1}, {4, 2}, {4, 3}, {1, 4}, {2, 4}, {3, 4}}))
      << "the edge belongs to the area";
}

TEST(LinkRules, TheNewestCounts) {
  LinkRule heal = cut({1}, {2});
  heal.loss.reset();
  EXPECT_EQ(heard_by(std::vector{cut({1}), heal}), all_but({{1, 3}, {1, 4}, {3, 1}, {4, 1}}));
  EXPECT_EQ(heard_by(std::vector{heal, cut({1})}), all_but({{1, 2}, {1, 3}, {1, 4}, {2, 1}, {3, 1}, {4, 1}}));
}

TEST(LinkRules, AHealedLinkHasTheScenariosLoss) {
  LinkRule heal = cut({1}, {2});
  heal.loss.reset();
  EXPECT_THAT(heard_by(std::vector{heal}, {.propagation = {.loss_probability = 1.0}}), IsEmpty());
}

TEST(LinkRules, DegradeALinkByAboutTheLossAskedFor) {
  const std::vector<LinkRule> rules{{.robots = {1}, .others = {2}, .area = {}, .loss = 0.3}};
  int crossed = 0;
  constexpr int kSteps = 2000;
  for (std::uint64_t step = 0; step < kSteps; ++step) {
    for (const auto& pair : heard_by(rules, {}, step)) crossed += pair == std::pair{1, 2} ? 1 : 0;
  }
  EXPECT_NEAR(crossed, 0.7 * kSteps, 100);
}

TEST(RadioControl, BeginsAtItsStepAndIsClearedAtAnother) {
  RadioControl control{4};
  EXPECT_EQ(control.ask({"me", 1, 10, AddRule{cut({1})}}, 3)->kind, Kind::kScheduled);
  EXPECT_EQ(control.ask({"me", 2, 12, ClearRules{}}, 3)->kind, Kind::kScheduled);
  EXPECT_THAT(control.reach(9), IsEmpty());
  EXPECT_FALSE(control.was_used());
  EXPECT_THAT(control.reach(10), ElementsAre(pure::Outcome{"me", 1, Kind::kDone, 10, ""}));
  EXPECT_EQ(control.rules().size(), 1U);
  EXPECT_TRUE(control.was_used());
  (void)control.reach(12);
  EXPECT_TRUE(control.rules().empty());
  EXPECT_TRUE(control.was_used());
}

TEST(RadioControl, RefusesWhatMakesNoSense) {
  RadioControl control{4};
  LinkRule loss = cut({1});
  loss.loss = std::numeric_limits<double>::quiet_NaN();
  LinkRule area = cut({});
  area.area = Area{1.0, 0.0, 0.0, 1.0};
  const std::vector<std::pair<LinkRule, std::string>> cases{
      {cut({5}), "no robot 5"}, {cut({1}, {0}), "no robot 0"}, {loss, "0 to 1"}, {area, "lower left"}};
  std::uint32_t id = 0;
  for (const auto& [rule, reason] : cases) {
    const auto outcome = control.ask({"me", ++id, 0, AddRule{rule}}, 3);
    EXPECT_EQ(outcome->kind, Kind::kRefused);
    EXPECT_THAT(outcome->reason, HasSubstr(reason));
  }
  EXPECT_THAT(control.ask({"me", ++id, 2, ClearRules{}}, 3)->reason, HasSubstr("step 2 has begun"));
}

}  // namespace
}  // namespace caravan::radio
