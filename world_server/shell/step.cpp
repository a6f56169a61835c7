// SPDX-License-Identifier: Apache-2.0
// The world's step: open, advance, finish.
#include <spdlog/spdlog.h>

#include "runtime/pure/digest.hpp"
#include "world_server/physics/physics_error.hpp"
#include "world_server/shell/world_shell.hpp"

namespace caravan::world {

void WorldShell::progress() {
  read_mailbox();
  for (;;) {
    switch (lockstep_.next(barrier_)) {
      case Move::kNone:
        return;
      case Move::kStart:
        if (!credits_.missing().empty()) return;
        tallies_.started = tallies_.last_status = std::chrono::steady_clock::now();
        pace_.start(tallies_.started);
        spdlog::info("started robots={} session={}", config_.robots.count, session_);
        open_step();
        break;
      case Move::kAdvance:
        advance();
        break;
      case Move::kClose:
        lockstep_.close();
        break;
      case Move::kOpenOrFinish:
        if (world_.finished()) return finish();
        reach_boundary();
        if (!may_open(std::chrono::steady_clock::now())) return;
        open_step();
        break;
    }
  }
}

bool WorldShell::may_open(Wall now) {
  if (control_.is_paused()) return false;
  hold_.update(credits_.holding_back(world_.now(), period_ * idl::kMaxStepsAhead), now);
  if (hold_.by) {
    woken_for_ = {};
    return false;
  }
  if (pace_.is_due(now, control_.speed())) return true;
  // The main thread opens it when it is due. It is woken once: it calls this function itself, and would wake
  // itself until then.
  if (woken_for_ != pace_.due()) loop_.notify();
  woken_for_ = pace_.due();
  return false;
}

void WorldShell::open_step() {
  const bool first = lockstep_.phase() == Phase::kWaiting;
  const Wall now = std::chrono::steady_clock::now();
  lockstep_.open(world_.now());
  barrier_.open(now);
  pace_.open(now, control_.speed());
  if (!first) publish_sensors();  // the first frames were published at the start
  publish_truth();
}

void WorldShell::advance() {
  const Stopwatch watch{tallies_.physics};
  for (std::uint32_t robot = 1; robot <= config_.robots.count; ++robot) {
    auto& command = inputs_.commands[robot - 1];
    if (command && control_.is_held(robot)) command->left_mps = command->right_mps = 0.0;
  }
  try {
    world_.advance(inputs_.commands);
  } catch (const PhysicsError& error) {
    lockstep_.fail();
    failure_ = error.what();
    loop_.notify();  // the main thread logs it and ends
    return;
  }
  if (!world_.complaint().empty() && tallies_.physics_complaints++ == 0) {
    spdlog::warn(
        "{} t={:.3f}: the solver continues with an approximate result (further warnings are counted)",
        world_.complaint(), std::chrono::duration<double>(lockstep_.stamp()).count());
  }
  if (trace_) trace_->record(world_.chain_link());
  inputs_.moved(follows_clock_);
  lockstep_.advance();
}

void WorldShell::finish() {
  lockstep_.finish(world_.now());
  tallies_.ended = std::chrono::steady_clock::now();
  // With bodies the run depends on wall time in every step, so it is not repeatable.
  if (config_.bodies.empty()) digest_ = pure::digest(world_.chain(), inputs_.radio_chain);
  outputs_.replies(control_.end());
  publish_truth();
  publish_status(tallies_.ended);
  spdlog::info("finished sim_s={:.3f} items={} digest={}",
               std::chrono::duration<double>(lockstep_.stamp()).count(), world_.items_delivered(),
               digest_.empty() ? "none" : digest_);
  if (tallies_.physics_complaints > 1)
    spdlog::warn("the physics solver warned in {} steps", tallies_.physics_complaints);
}

void WorldShell::publish_sensors() {
  // In pacing `free` no robot waits for its frames.
  if (follows_clock_) inputs_.forget_radio();
  outputs_.sensors(world_, lockstep_.stamp(), inputs_.radio_due, tallies_.sensors);
  inputs_.forget_radio();
}

void WorldShell::publish_truth() {
  const bool last = lockstep_.phase() == Phase::kFinished;
  const auto members = last ? std::vector<std::uint32_t>{} : barrier_.members();
  outputs_.truth(world_, members, inputs_.reported, lockstep_.stamp(), last);
}

}  // namespace caravan::world
