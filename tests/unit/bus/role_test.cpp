// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/role.hpp"

#include <gtest/gtest.h>

#include "runtime/bus/participant.hpp"

namespace caravan::runtime {
namespace {

Identity ours(const std::string& role) { return to_identity(to_name(own_identity(role))); }

TEST(StatedRole, IsTheFirstWordOfAProcessOfOurs) {
  EXPECT_EQ(stated_role(ours("world_server")), idl::Party::kWorld);
  EXPECT_EQ(stated_role(ours("robot_agent 3-7")), idl::Party::kAgent);
  EXPECT_EQ(stated_role(ours("my_bridge 3")), std::nullopt);
  EXPECT_EQ(stated_role(ours("")), std::nullopt);
}

TEST(StatedRole, IsNotStatedByANameAlone) {
  EXPECT_EQ(stated_role(to_identity("world_server")), std::nullopt);
  EXPECT_EQ(stated_role(to_identity("caravan|world_server|here|12|0")), std::nullopt);
  EXPECT_EQ(stated_role(Identity{}), std::nullopt);
}

TEST(ClaimOf, EachTopicIsForThoseThatTheTableNames) {
  const Identity world = ours("world_server");
  EXPECT_EQ(claim_of(idl::kTruth, world), Claim::kFull);
  EXPECT_EQ(claim_of(idl::kSensors, world), Claim::kFull);
  EXPECT_EQ(claim_of(idl::kRadioStep, world), Claim::kNone);
  EXPECT_EQ(claim_of(idl::kCommand, world), Claim::kNone);
  EXPECT_EQ(claim_of(idl::kSensors, ours("pioneer_bridge 3")), Claim::kFull);
  EXPECT_EQ(claim_of(idl::kRunCredit, ours("launcher")), Claim::kFull);
  EXPECT_EQ(claim_of(idl::kTruth, ours("robot_agent 1")), Claim::kNone);
}

TEST(ClaimOf, WhoStatesNoRoleMayBeAnAgentOrABridgeAndNothingElse) {
  const Identity foreign = to_identity("/my_ros_node");
  EXPECT_EQ(claim_of(idl::kCommand, foreign), Claim::kFull);
  EXPECT_EQ(claim_of(idl::kTelemetry, foreign), Claim::kFull);
  EXPECT_EQ(claim_of(idl::kSensors, foreign), Claim::kWeak);
  EXPECT_EQ(claim_of(idl::kRadioReceive, foreign), Claim::kWeak);
  for (const idl::Topic& topic : idl::kTopics) {
    if (topic.name.starts_with("rt/robot_")) continue;
    EXPECT_EQ(claim_of(topic, foreign), Claim::kNone) << topic.name;
  }
}

TEST(ParticipantText, IsTheProcessForOursAndTheGuidForOthers) {
  ParticipantId id;
  id.prefix = {0x01, 0x0f, 0xab};
  Identity foreign = to_identity("/talker");

  EXPECT_EQ(to_text(id, {"robot_agent 3", "lab", 77, 5}), "robot_agent 3 pid 77 on host lab");
  EXPECT_EQ(to_text(id, foreign), "participant 01.0f.ab.00.00.00.00.00.00.00.00.00 \"/talker\"");
  foreign.pid = 12;
  foreign.host = "lab";
  EXPECT_EQ(to_text(id, foreign),
            "participant 01.0f.ab.00.00.00.00.00.00.00.00.00 \"/talker\" pid 12 on host lab");
  EXPECT_EQ(to_text(id, Identity{}), "participant 01.0f.ab.00.00.00.00.00.00.00.00.00");
}

TEST(ParticipantText, HasPrintableCharactersOnlyAndIsShort) {
  EXPECT_EQ(to_identity("a\x1b[2Jb\nc\xff").role, "a?[2Jb?c?");
  EXPECT_EQ(to_identity(std::string(300, 'x')).role.size(), 80U);
}

}  // namespace
}  // namespace caravan::runtime
