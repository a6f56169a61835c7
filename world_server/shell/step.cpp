// SPDX-License-Identifier: Apache-2.0
// The world's step: open, publish, advance, finish.
#include <spdlog/spdlog.h>

#include <utility>

#include "idl/stamp.hpp"
#include "runtime/pure/digest.hpp"
#include "world_server/physics/physics_error.hpp"
#include "world_server/shell/wire.hpp"
#include "world_server/shell/world_shell.hpp"

namespace caravan::world {
using runtime::Claim;
using runtime::Discovery;
using runtime::Pacing;
using runtime::ParticipantId;
using runtime::Tenure;
using namespace std::chrono_literals;

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
    if (claim != Claim::kNone) agents_[robot - 1].push_back({writer.participant, claim});
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
  if (members_changed && (phase_ == Phase::kOpen || phase_ == Phase::kAdvanced)) publish_truth(false);
}

bool WorldShell::forget_agent(std::uint32_t robot, const Discovery& gone) {
  std::erase_if(agents_[robot - 1], [&](const ParticipantId& one) { return one == gone.participant; });
  if (!drivers_[robot - 1].release(gone.participant)) return false;
  spdlog::warn("robot lost robot={}: {}", robot, to_text(gone.participant, gone.identity));
  const bool members_changed = barrier_.lose(robot, std::chrono::steady_clock::now());
  commands_[robot - 1].reset();
  hand_over(drivers_[robot - 1]);
  return members_changed;
}

void WorldShell::hand_over(Tenure& tenure) {
  for (const Tenure::Later& take : tenure.hand_over()) take();
  if (const auto holder = tenure.holder()) bus_.forgive(*holder);
}

void WorldShell::forget_radio(const Discovery& gone) {
  if (!radio_.release(gone.participant)) return;
  spdlog::warn("radio lost: {}; the robots drive on alone", to_text(gone.participant, gone.identity));
  barrier_.lose_radio();
  radio_due_.assign(radio_due_.size(), false);
  hand_over(radio_);
}

void WorldShell::progress() {
  read_mailbox();
  const bool free = config_.experiment.pacing == Pacing::kFree;
  for (;;) {
    switch (phase_) {
      case Phase::kWaiting:
        if (!barrier_.missing().empty() || !credits_.missing().empty()) return;
        tallies_.started = tallies_.last_status = due_ = std::chrono::steady_clock::now();
        spdlog::info("started robots={} session={}", config_.robots.count, session_);
        open_step();
        break;
      case Phase::kOpen:
        if (free || !barrier_.commands_in()) return;
        advance();
        break;
      case Phase::kAdvanced:
        if (free || !barrier_.radio_in()) return;
        phase_ = Phase::kClosed;
        break;
      case Phase::kClosed:
        if (world_.finished()) return finish();
        reach_boundary();
        if (!may_open(std::chrono::steady_clock::now())) return;
        open_step();
        break;
      case Phase::kFinished:
      case Phase::kFailed:
        return;
    }
  }
}

bool WorldShell::may_open(Wall now) {
  if (control_.is_paused()) return false;
  const bool was_held = held_by_.has_value();
  held_by_ = credits_.holding_back(world_.now(), period_ * idl::kMaxStepsAhead);
  if (held_by_) {
    if (!was_held) held_since_ = now;
    notified_due_ = {};
    return false;
  }
  if (control_.speed() == 0.0 || now >= due_) return true;
  // The main thread opens it when it is due. Told once: it asks here itself, and would wake itself until
  // then.
  if (notified_due_ != due_) loop_.notify();
  notified_due_ = due_;
  return false;
}

void WorldShell::open_step() {
  const bool first = phase_ == Phase::kWaiting;
  const Wall now = std::chrono::steady_clock::now();
  stamp_ = world_.now();
  barrier_.open(now);
  phase_ = Phase::kOpen;
  const double speed = control_.speed() == 0.0 ? 1.0 : control_.speed();
  const auto period = std::chrono::duration_cast<Wall::duration>(
      std::chrono::duration<double, std::nano>(static_cast<double>(period_.count()) / speed));
  due_ = now - due_ > 100ms ? now + period : due_ + period;  // a hold is not caught up with
  if (!first) publish_sensors();                             // the first frames have been out since the start
  publish_truth(false);
}

void WorldShell::publish_sensors() {
  const bool lockstep = config_.experiment.pacing != Pacing::kFree;
  rosgraph_msgs::msg::Clock clock;
  clock.clock(idl::to_wire(stamp_));
  clock_.write(clock);
  frame_.stamp(idl::to_wire(stamp_));
  frame_.session(session_);
  for (std::uint32_t robot = 1; robot <= config_.robots.count; ++robot) {
    if (!world_.is_present(robot)) continue;
    {
      const Stopwatch watch{tallies_.sensors};
      to_wire(world_.sense(robot), frame_);
    }
    frame_.radio_due(lockstep && radio_due_[robot - 1]);
    if (!sensors_[robot - 1].write(frame_)) ++tallies_.refused_writes;
  }
  radio_due_.assign(radio_due_.size(), false);
}

void WorldShell::publish_truth(bool last) {
  to_wire(world_, barrier_.members(), truth_);
  truth_.stamp(idl::to_wire(stamp_));
  truth_.next_stamp(idl::to_wire(stamp_ + period_));
  truth_.session(session_);
  truth_.last(last);
  if (last) truth_.members().clear();
  if (!truths_.write(truth_)) ++tallies_.refused_writes;
}

void WorldShell::advance() {
  const Stopwatch watch{tallies_.physics};
  for (std::uint32_t robot = 1; robot <= config_.robots.count; ++robot) {
    auto& command = commands_[robot - 1];
    if (command && control_.is_held(robot)) command->left_mps = command->right_mps = 0.0;
  }
  try {
    world_.advance(commands_);
  } catch (const PhysicsError& error) {
    fail(error.what());
    return;
  }
  if (!world_.complaint().empty() && tallies_.physics_complaints++ == 0) {
    spdlog::warn("{} t={:.3f}: the solver goes on with what it has (further ones are counted)",
                 world_.complaint(), std::chrono::duration<double>(stamp_).count());
  }
  truth_.reported(std::exchange(reporting_, {}));
  if (trace_) trace_->record(world_.chain_link());
  if (config_.experiment.pacing != Pacing::kFree) commands_.assign(commands_.size(), std::nullopt);
  phase_ = Phase::kAdvanced;
}

void WorldShell::fail(const std::string& reason) {
  phase_ = Phase::kFailed;
  failure_ = reason;
  loop_.notify();  // the main thread tells it and ends
}

void WorldShell::finish() {
  phase_ = Phase::kFinished;
  stamp_ = world_.now();
  tallies_.ended = std::chrono::steady_clock::now();
  // With bodies the run depends on wall time in every step: nobody could repeat it.
  if (config_.bodies.empty()) digest_ = pure::digest(world_.chain(), radio_chain_);
  reply(control_.end());
  publish_truth(true);
  publish_status(tallies_.ended);
  spdlog::info("finished sim_s={:.3f} items={} digest={}", std::chrono::duration<double>(stamp_).count(),
               world_.items_delivered(), digest_.empty() ? "none" : digest_);
  if (tallies_.physics_complaints > 1)
    spdlog::warn("the physics' solver complained in {} steps", tallies_.physics_complaints);
}

}  // namespace caravan::world
