// SPDX-License-Identifier: Apache-2.0
// Participants found and lost: agents, the radio, observers.
#include <spdlog/spdlog.h>

#include <algorithm>

#include "world_server/shell/world_shell.hpp"

namespace caravan::world {
using runtime::Claim;
using runtime::Discovery;
using runtime::ParticipantId;
using runtime::Tenure;

const idl::Topic& WorldShell::command_topic(std::uint32_t robot) const {
  return config_.is_body(robot) ? idl::kBodyCommand : idl::kCommand;
}

void WorldShell::read_mailbox() {
  for (const Discovery& one : mailbox_.take()) {
    if (one.kind == Discovery::Kind::kWriterFound) {
      meet(one);
    } else {
      forget(one);
    }
  }
}

void WorldShell::meet(const Discovery& writer) {
  for (std::uint32_t robot = 1; robot <= config_.robots.count; ++robot) {
    if (writer.topic != idl::name_for(idl::kCommand, robot)) continue;
    const Claim claim = claim_of(idl::kCommand, writer.identity);
    if (claim != Claim::kNone) drivers_[robot - 1].agents.push_back({writer.participant, claim});
  }
}

void WorldShell::forget(const Discovery& gone) {
  const auto concerns = [&gone](const idl::Topic& topic, std::uint32_t robot = 0) {
    return gone.kind == Discovery::Kind::kGone || gone.topic == idl::name_for(topic, robot);
  };
  if (concerns(idl::kRunCredit)) credits_.lose(gone.participant);
  bool members_changed = false;
  for (std::uint32_t robot = 1; robot <= config_.robots.count; ++robot) {
    if (concerns(command_topic(robot), robot)) members_changed = forget_agent(robot, gone) || members_changed;
  }
  if (concerns(idl::kRadioStep)) forget_radio(gone);
  if (members_changed && lockstep_.is_in_step()) publish_truth();
}

bool WorldShell::forget_agent(std::uint32_t robot, const Discovery& gone) {
  Driver& driver = drivers_[robot - 1];
  std::erase_if(driver.agents, [&](const ParticipantId& one) { return one == gone.participant; });
  if (!driver.tenure.release(gone.participant)) return false;
  spdlog::warn("robot lost robot={}: {}", robot, to_text(gone.participant, gone.identity));
  const bool members_changed = barrier_.lose(robot, std::chrono::steady_clock::now());
  inputs_.drop(robot);
  hand_over(driver.tenure);
  return members_changed;
}

void WorldShell::forget_radio(const Discovery& gone) {
  if (!radio_.release(gone.participant)) return;
  spdlog::warn("radio lost: {}; the robots continue without it", to_text(gone.participant, gone.identity));
  barrier_.lose_radio();
  inputs_.forget_radio();
  hand_over(radio_);
}

void WorldShell::hand_over(Tenure& tenure) {
  for (const Tenure::Later& take : tenure.hand_over()) take();
  if (const auto holder = tenure.holder()) bus_.forgive(*holder);
}

}  // namespace caravan::world
