// SPDX-License-Identifier: Apache-2.0
// What arrives at the world: commands, the radio's answers, credit.
#include <spdlog/spdlog.h>

#include "idl/stamp.hpp"
#include "world_server/referee/sanitise.hpp"
#include "world_server/shell/world_shell.hpp"

namespace caravan::world {
namespace msg = caravan_interfaces::msg;
using runtime::Pacing;
using runtime::Sender;
using runtime::Tenure;

bool WorldShell::is_current(std::uint64_t session, Time stamp) const {
  if (session != session_ || phase_ == Phase::kFinished) return false;
  return config_.experiment.pacing == Pacing::kFree ? stamp_ - stamp <= kDeadman : stamp == stamp_;
}

const idl::Topic& WorldShell::command_topic(std::uint32_t robot) const {
  return config_.is_body(robot) ? idl::kBodyCommand : idl::kCommand;
}

void WorldShell::on_command(std::uint32_t robot, const msg::RobotCommand& sample, const Sender& sender) {
  const std::lock_guard lock{mutex_};
  // Of another session: a claim to nothing. A robot begins anew with each.
  if (sample.session() != session_) {
    ++tallies_.stale_samples;
    return;
  }
  Tenure& driver = drivers_[robot - 1];
  if (driver.claim(sender) != Tenure::Standing::kRefused) {
    take_command(robot, sample);
    progress();
    return;
  }
  ++tallies_.stale_samples;
  bus_.refuse(sender, command_topic(robot), robot);
  driver.keep(sender, [this, robot, sample] { take_command(robot, sample); });
}

void WorldShell::take_command(std::uint32_t robot, const msg::RobotCommand& sample) {
  if (!is_current(sample.session(), idl::to_time(sample.stamp()))) {
    ++tallies_.stale_samples;
    barrier_.answer_late(robot);
    return;
  }
  const Sanitised safe = sanitise(sample.left_mps(), sample.right_mps(), config_.robots.wheel_limit_mps);
  if (safe.refused && tallies_.refused_commands[robot - 1]++ == 0) {
    spdlog::warn(
        "command refused robot={}: not finite, its wheels stop (further ones are counted in the status)",
        robot);
  }
  if (safe.clamped && tallies_.clamped_commands[robot - 1]++ == 0) {
    spdlog::warn(
        "command clamped robot={}: beyond the wheel limit of {} m/s (further ones are counted in the status)",
        robot, config_.robots.wheel_limit_mps);
  }
  if (sample.reported() && idl::to_time(sample.stamp()) == stamp_) reporting_.push_back(robot);
  const Answer answer = barrier_.answer(robot);
  if (answer != Answer::kNextStep || phase_ == Phase::kWaiting) {
    commands_[robot - 1] = Command{safe.left_mps, safe.right_mps, sample.gripper_closed()};
    commanded_at_[robot - 1] = stamp_;
  }
  if (answer == Answer::kRevives) publish_truth(false);
}

void WorldShell::on_radio_step(const msg::RadioStep& sample, const Sender& sender) {
  const std::lock_guard lock{mutex_};
  if (sample.session() != session_) {
    ++tallies_.stale_samples;
    return;
  }
  if (radio_.claim(sender) != Tenure::Standing::kRefused) {
    take_radio_step(sample);
    progress();
    return;
  }
  ++tallies_.stale_samples;
  bus_.refuse(sender, idl::kRadioStep);
  radio_.keep(sender, [this, sample] { take_radio_step(sample); });
}

void WorldShell::take_radio_step(const msg::RadioStep& sample) {
  if (!is_current(sample.session(), idl::to_time(sample.stamp()))) {
    ++tallies_.stale_samples;
    barrier_.answer_radio_late();
    return;
  }
  for (const std::uint32_t robot : sample.receivers()) {
    if (robot >= 1 && robot <= radio_due_.size()) radio_due_[robot - 1] = true;
  }
  radio_chain_ = sample.chain();
  radio_controlled_ = radio_controlled_ || sample.controlled();
  barrier_.answer_radio();
}

void WorldShell::on_credit(const msg::RunCredit& sample, const Sender& sender) {
  const std::lock_guard lock{mutex_};
  const bool ours = sample.session() == session_;
  if (!credits_.give(sample.observer(), sender, ours ? idl::to_time(sample.stamp()) : Time{0}))
    bus_.refuse(sender, idl::kRunCredit);
  progress();
}

}  // namespace caravan::world
