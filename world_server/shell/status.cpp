// SPDX-License-Identifier: Apache-2.0
// The world's status and warnings.
#include <spdlog/spdlog.h>

#include <numeric>

#include "idl/stamp.hpp"
#include "world_server/shell/world_shell.hpp"

namespace caravan::world {
namespace msg = caravan_interfaces::msg;
using namespace std::chrono_literals;

namespace {

constexpr auto kStatusPeriod = 500ms;
constexpr auto kHeldLong = 2s;      // by an observer
constexpr auto kHeldTooLong = 10s;  // by one that is not awaited

std::vector<std::string> to_text(const std::vector<std::uint32_t>& ids) {
  std::vector<std::string> names;
  for (const std::uint32_t id : ids) names.push_back(id == 0 ? "radio" : "robot " + std::to_string(id));
  return names;
}

std::uint64_t sum(const std::vector<std::uint64_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

std::vector<std::uint32_t> removed(const World& world, std::uint32_t robots) {
  std::vector<std::uint32_t> ids;
  for (std::uint32_t robot = 1; robot <= robots; ++robot) {
    if (!world.is_present(robot)) ids.push_back(robot);
  }
  return ids;
}

double seconds(std::chrono::nanoseconds time) { return std::chrono::duration<double>(time).count(); }

}  // namespace

void WorldShell::name_the_late(Wall now) {
  const std::vector<std::uint32_t> hung = barrier_.hung(now);
  if (hung != logged_.hung && !hung.empty()) {
    spdlog::warn("hung stamp_s={:.3f}: alive but not answering: {}", seconds(lockstep_.stamp()),
                 fmt::join(to_text(hung), ", "));
  }
  logged_.hung = hung;
  const bool held = lockstep_.phase() == Phase::kClosed && !control_.is_paused() && hold_.by &&
                    now - hold_.since >= kHeldLong;
  if (held && !logged_.hold) {
    spdlog::warn("held back stamp_s={:.3f}: observer {} is alive but handles no more steps",
                 seconds(lockstep_.stamp()), *hold_.by);
  }
  logged_.hold = held;
  if (held && !credits_.is_awaited(*hold_.by) && now - hold_.since >= kHeldTooLong) {
    spdlog::warn("observer {} is no longer waited for: it may miss steps", *hold_.by);
    credits_.let_go(*hold_.by);
  }
}

std::string WorldShell::held(Wall now) const {
  if (lockstep_.phase() != Phase::kClosed || control_.is_paused()) return "";
  if (logged_.hold) return "observer " + *hold_.by + " is alive but handles no more steps";
  const Wall::duration left = pace_.due() - now;
  if (hold_.by || control_.speed() == 0.0 || left < 1s) return "";
  return fmt::format(
      "the world runs at {} times real time, its next step is due in {:.0f} s "
      "(`caravan ctl speed` takes {} to {}, or max)",
      control_.speed(), seconds(left), Control::kSlowest, Control::kFastest);
}

void WorldShell::publish_status(Wall now) {
  status_due_ = now + kStatusPeriod;
  const double since = seconds(now - tallies_.last_status);
  const std::uint64_t steps = world_.step();
  const Phase phase = lockstep_.phase();
  msg::WorldStatus status;
  status.stamp(idl::to_wire(lockstep_.stamp()));
  status.session(session_);
  status.state(phase == Phase::kWaiting    ? msg::WorldStatus_Constants::WAITING
               : phase == Phase::kFinished ? msg::WorldStatus_Constants::FINISHED
                                           : msg::WorldStatus_Constants::RUNNING);
  status.missing(missing());
  status.hung(to_text(logged_.hung));
  status.gone(to_text(barrier_.gone()));
  status.removed(to_text(removed(world_, config_.robots.count)));
  status.members(static_cast<std::uint32_t>(barrier_.members().size()));
  status.steps_per_s(since > 0.0 ? static_cast<double>(steps - tallies_.steps_at_status) / since : 0.0);
  status.items_delivered(world_.items_delivered());
  status.completed(phase == Phase::kFinished && config_.experiment.items > 0 &&
                   world_.items_delivered() >= config_.experiment.items);
  status.disturbed(barrier_.disturbed() || control_.was_used() || inputs_.radio_controlled);
  status.paused(control_.is_paused());
  status.held(held(now));
  status.digest(digest_);
  status.steps(steps);
  status.refused_commands(sum(tallies_.refused_commands));
  status.clamped_commands(sum(tallies_.clamped_commands));
  status.stale_samples(tallies_.stale_samples);
  for (const runtime::Stranger& one : bus_.strangers()) status.strangers().push_back(to_text(one));
  status.empty_closings(world_.empty_closings());
  const Wall until = phase == Phase::kFinished ? tallies_.ended : now;
  status.wall_s(phase == Phase::kWaiting ? 0.0 : seconds(until - tallies_.started));
  status.physics_s(seconds(tallies_.physics));
  status.sensors_s(seconds(tallies_.sensors));
  tallies_.steps_at_status = steps;
  tallies_.last_status = now;
  outputs_.status(status);
  if (outputs_.refused() > 0 && !logged_.refused_writes) {
    spdlog::error("DDS refused a sample: an observer may have missed a step");
    logged_.refused_writes = true;
  }
}

}  // namespace caravan::world
