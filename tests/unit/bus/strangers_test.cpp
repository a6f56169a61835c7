// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/strangers.hpp"

#include <gmock/gmock.h>

namespace caravan::runtime {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

ParticipantId participant(std::uint8_t number) {
  ParticipantId id;
  id.prefix[0] = number;
  return id;
}

TEST(Strangers, CountsSamplesOfEachParticipant) {
  Strangers strangers;
  const Identity identity{"robot_agent 1", "lab", 7, 5};
  strangers.refuse(participant(1), identity, "rt/world/truth", Refusal::kNotItsRole);
  strangers.refuse(participant(1), identity, "rt/world/status", Refusal::kNotItsRole);
  strangers.refuse(participant(2), {}, "rt/world/truth", Refusal::kMalformed);

  const auto all = strangers.all();

  ASSERT_THAT(all, SizeIs(2));
  EXPECT_EQ(all[0].who, "robot_agent 1 pid 7 on host lab");
  EXPECT_EQ(all[0].refused, 2U);
  EXPECT_THAT(all[0].topics, ElementsAre("rt/world/status", "rt/world/truth"));
  EXPECT_EQ(to_text(all[0]),
            "robot_agent 1 pid 7 on host lab: 2 samples refused on rt/world/status, rt/world/truth");
}

TEST(Strangers, ForgetsOneThatHoldsTheRoleAtLast) {
  Strangers strangers;
  strangers.refuse(participant(1), {}, "rt/robot_1/command", Refusal::kRoleIsHeld);

  strangers.forgive(participant(1));

  EXPECT_THAT(strangers.all(), SizeIs(0));
}

TEST(Strangers, AreBoundedHoweverManyCome) {
  Strangers strangers;
  for (int i = 0; i < 100; ++i) {
    for (int topic = 0; topic < 100; ++topic) {
      strangers.refuse(participant(static_cast<std::uint8_t>(i)), {}, "rt/" + std::to_string(topic),
                       Refusal::kMalformed);
    }
  }

  const auto all = strangers.all();

  ASSERT_THAT(all, SizeIs(33));
  EXPECT_EQ(all.back().who, "further participants");
  EXPECT_EQ(all.back().refused, 68U * 100U);
  for (const Stranger& one : all) EXPECT_THAT(one.topics, SizeIs(16));
}

}  // namespace
}  // namespace caravan::runtime
