// SPDX-License-Identifier: Apache-2.0
// The world's main thread: pacing, late processes, the end.
#include <spdlog/spdlog.h>

#include <algorithm>

#include "runtime/process/run_process.hpp"
#include "world_server/shell/world_shell.hpp"

namespace caravan::world {

int WorldShell::run() {
  const Wall began = std::chrono::steady_clock::now();
  const auto patience = std::chrono::duration_cast<Wall::duration>(
      std::chrono::duration<double>(config_.experiment.start_timeout_s));
  for (;;) {
    Wall deadline;
    {
      const std::lock_guard lock{mutex_};
      const Wall now = std::chrono::steady_clock::now();
      watch(now);
      if (lockstep_.phase() == Phase::kFailed) {
        spdlog::error("t={:.3f} s: {}: the run ends here",
                      std::chrono::duration<double>(lockstep_.stamp()).count(), failure_);
        return runtime::kFailed;
      }
      if (lockstep_.phase() == Phase::kWaiting && now - began > patience) {
        spdlog::error("cannot start: after {} s still missing: {}", config_.experiment.start_timeout_s,
                      fmt::join(missing(), ", "));
        return runtime::kCouldNotStart;
      }
      deadline = next_deadline(now);
    }
    if (loop_.wait(deadline) == runtime::Loop::Woken::kStop) return runtime::kDone;
    if (loop_.was_suspended_for(lease_s_)) {
      spdlog::error(
          "suspended for longer than the lease: all processes have dropped this world; start a new one");
      return runtime::kFailed;
    }
  }
}

void WorldShell::watch(Wall now) {
  progress();
  if (follows_clock_ && lockstep_.phase() == Phase::kOpen && now >= pace_.due()) free_step();
  if (barrier_.let_go(now)) {
    publish_truth();
    progress();
  }
  if (now >= status_due_) {
    name_the_late(now);
    publish_status(now);
    if (trace_) trace_->keep_up();
  }
}

void WorldShell::free_step() {
  inputs_.drop_older(lockstep_.stamp(), kDeadman);
  advance();
  if (lockstep_.is_over()) return;
  lockstep_.close();
  if (world_.finished()) return finish();
  reach_boundary();
  if (!control_.is_paused()) open_step();
}

Wall WorldShell::next_deadline(Wall now) const {
  const bool paced =
      control_.speed() != 0.0 && !hold_.by && !control_.is_paused() &&
      (lockstep_.phase() == Phase::kClosed || (lockstep_.phase() == Phase::kOpen && follows_clock_));
  return paced ? std::min(status_due_, std::max(pace_.due(), now)) : status_due_;
}

std::vector<std::string> WorldShell::missing() const {
  std::vector<std::string> names = credits_.missing();
  for (const std::uint32_t robot : barrier_.missing()) names.push_back("robot " + std::to_string(robot));
  return names;
}

}  // namespace caravan::world
