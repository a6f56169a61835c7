// SPDX-License-Identifier: Apache-2.0
// Samples that arrive at the world: commands, the radio's answers, credit.
#include <spdlog/spdlog.h>

#include "idl/stamp.hpp"
#include "world_server/referee/sanitise.hpp"
#include "world_server/shell/world_shell.hpp"

namespace caravan::world {
namespace msg = caravan_interfaces::msg;
using runtime::Sender;
using runtime::Tenure;

void WorldShell::on_command(std::uint32_t robot, const msg::RobotCommand& sample, const Sender& sender) {
  const std::lock_guard lock{mutex_};
  // A sample of another session claims nothing. A robot resets with each session.
  if (sample.session() != session_) {
    ++tallies_.stale_samples;
    return;
  }
  Tenure& driver = drivers_[robot - 1].tenure;
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
  const Time stamp = idl::to_time(sample.stamp());
  if (!lockstep_.is_current(stamp)) {
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
  if (sample.reported() && stamp == lockstep_.stamp()) inputs_.reporting.push_back(robot);
  const Answer answer = barrier_.answer(robot);
  if (answer != Answer::kNextStep || lockstep_.phase() == Phase::kWaiting)
    inputs_.command(robot, {safe.left_mps, safe.right_mps, sample.gripper_closed()}, lockstep_.stamp());
  if (answer == Answer::kRevives) publish_truth();
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
  if (!lockstep_.is_current(idl::to_time(sample.stamp()))) {
    ++tallies_.stale_samples;
    barrier_.answer_radio_late();
    return;
  }
  for (const std::uint32_t robot : sample.receivers()) {
    if (robot >= 1 && robot <= config_.robots.count) inputs_.radio_due[robot - 1] = true;
  }
  inputs_.radio_chain = sample.chain();
  inputs_.radio_controlled = inputs_.radio_controlled || sample.controlled();
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
