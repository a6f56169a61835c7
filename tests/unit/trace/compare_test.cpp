// SPDX-License-Identifier: Apache-2.0
#include "experiment/trace/compare.hpp"

#include <gmock/gmock.h>

namespace caravan::experiment {
namespace {

TracedStep step() {
  return {.world = {.placements = {},
                    .number = 3,
                    .commands = {{true, 0.1, 0.2, false}, {true, 0.3, 0.4, true}},
                    .poses = {{1.0, 2.0, 0.5}, {3.0, 4.0, -0.5}}},
          .radio = {.stamp_ns = 64000000,
                    .sent = {{1, {0, {{0, {1, 2}}}}}, {2, {5, {{5, {}}}}}},
                    .heard = {{2, {{0, {1, 2}}}}}}};
}

/// "robot quantity: one | other" for each difference after `change` was applied to the second step.
template <typename Change>
std::vector<std::string> found(Change change) {
  const TracedStep one = step();
  TracedStep other = step();
  change(other);
  std::vector<std::string> texts;
  for (const Difference& difference : differences(one, other)) {
    texts.push_back(std::to_string(difference.robot) + " " + difference.quantity + ": " + difference.one +
                    " | " + difference.other);
  }
  return texts;
}

using testing::ElementsAre;

TEST(Differences, OfEqualStepsAreNone) {
  EXPECT_THAT(found([](TracedStep&) {}), testing::IsEmpty());
}

TEST(Differences, NameRobotAndQuantityOfAnyValue) {
  EXPECT_THAT(found([](TracedStep& s) { s.world.number = 4; }), ElementsAre("0 step.number: 3 | 4"));
  EXPECT_THAT(found([](TracedStep& s) { s.world.commands[1].given = false; }),
              ElementsAre("2 command.given: yes | no"));
  EXPECT_THAT(found([](TracedStep& s) { s.world.commands[0].left_mps = 0.30000000000000004; }),
              ElementsAre("1 command.left_mps: 0.1 | 0.30000000000000004"));
  EXPECT_THAT(found([](TracedStep& s) { s.world.commands[1].right_mps = -1; }),
              ElementsAre("2 command.right_mps: 0.4 | -1"));
  EXPECT_THAT(found([](TracedStep& s) { s.world.commands[0].gripper_closed = true; }),
              ElementsAre("1 command.gripper_closed: no | yes"));
  EXPECT_THAT(found([](TracedStep& s) { s.radio.stamp_ns = 1; }),
              ElementsAre("0 step.stamp_ns: 64000000 | 1"));
  EXPECT_THAT(found([](TracedStep& s) { s.radio.sent[2].tuned = 6; }),
              ElementsAre("2 transmission.tuned_channel: 5 | 6"));
  EXPECT_THAT(found([](TracedStep& s) { s.radio.sent[1].frames[0].bytes[1] = 255; }),
              ElementsAre("1 transmission.frame_1.bytes: 0102 | 01ff"));
  EXPECT_THAT(
      found([](TracedStep& s) {
        s.radio.sent[2].frames[0] = {7, {1}};
      }),
      ElementsAre("2 transmission.frame_1.channel: 5 | 7", "2 transmission.frame_1.bytes: empty | 01"));
  EXPECT_THAT(found([](TracedStep& s) { s.radio.heard[2].clear(); }),
              ElementsAre("2 delivery.frames: 1 | 0"));
  EXPECT_THAT(found([](TracedStep& s) { s.world.poses[1].yaw_rad = 0.25; }),
              ElementsAre("2 pose.yaw_rad: -0.5 | 0.25"));
}

TEST(Differences, NameRobotsThatWerePutElsewhere) {
  EXPECT_THAT(found([](TracedStep& s) {
                s.world.placements.push_back({2, {{}, {}}});
              }),
              ElementsAre("0 placements: 0 | 1"));
}

TEST(Differences, TellWhoTransmitsOrReceivesInOneRunOnly) {
  EXPECT_THAT(found([](TracedStep& s) { s.radio.sent.erase(1); }),
              ElementsAre("1 transmission: 1 frames | none"));
  EXPECT_THAT(found([](TracedStep& s) {
                s.radio.heard[1] = {{0, {}}, {0, {}}};
              }),
              ElementsAre("1 delivery: none | 2 frames"));
}

TEST(Differences, ComeInTheOrderInWhichOneLeadsToAnother) {
  EXPECT_THAT(found([](TracedStep& s) {
                s.world.poses[0].x_m = 9;
                s.radio.heard.clear();
                s.radio.sent[1].tuned = 9;
                s.world.commands[1].left_mps = 9;
              }),
              ElementsAre("2 command.left_mps: 0.3 | 9", "1 transmission.tuned_channel: 0 | 9",
                          "2 delivery: 1 frames | none", "1 pose.x_m: 1 | 9"));
}

}  // namespace
}  // namespace caravan::experiment
