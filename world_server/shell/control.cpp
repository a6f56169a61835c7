// SPDX-License-Identifier: Apache-2.0
// What is asked of the running world, and its answers.
#include "runtime/control/reply.hpp"
#include "world_server/shell/world_shell.hpp"

namespace caravan::world {
namespace msg = caravan_interfaces::msg;

namespace {

namespace kind = msg::ControlRequest_Constants;

bool is_for_the_radio(const msg::ControlRequest& request) {
  return request.action() == kind::RADIO_OVERRIDE || request.action() == kind::RADIO_CLEAR;
}

Action to_action(const msg::ControlRequest& request) {
  const std::uint32_t robot = request.robots().empty() ? 0 : request.robots().front();
  switch (request.action()) {
    case kind::PAUSE:
      return Pause{};
    case kind::RESUME:
      return Resume{};
    case kind::STEP:
      return TakeSteps{request.steps()};
    case kind::SPEED:
      return SetSpeed{request.speed_factor()};
    case kind::TELEPORT:
      return Teleport{robot, {request.x_m(), request.y_m(), request.yaw_rad()}};
    case kind::HOLD:
      return Hold{robot};
    case kind::RELEASE:
      return Release{robot};
    case kind::SPAWN:
      return Spawn{robot, {request.x_m(), request.y_m(), request.yaw_rad()}};
    case kind::REMOVE:
      return Remove{robot};
    default:
      return UnknownAction{};
  }
}

}  // namespace

std::uint64_t WorldShell::next_step() const {
  // Step 0 is as it is: its sensors are out from the start. An open step counts as taken once it has moved.
  if (phase_ == Phase::kWaiting) return 1;
  return world_.step() + (phase_ == Phase::kOpen ? 1 : 0);
}

bool WorldShell::is_disturbed() const {
  return barrier_.disturbed() || control_.was_used() || radio_controlled_;
}

void WorldShell::on_control(const msg::ControlRequest& request) {
  if (is_for_the_radio(request)) return;
  const std::lock_guard lock{mutex_};
  if (request.session() != session_) {
    reply({{request.requester(), request.id(), Outcome::Kind::kRefused, 0, "that session is over"}});
    return;
  }
  const auto outcome =
      control_.ask({request.requester(), request.id(), request.at_step(), to_action(request)}, next_step());
  if (!outcome) return;
  reply({*outcome});
  progress();
  loop_.notify();  // a deadline may have changed, and the status
}

void WorldShell::reach_boundary() {
  const bool was_paused = control_.is_paused();
  reply(control_.reach(
      world_.step(),
      {.teleport = [this](const Teleport& teleport) { return world_.place(teleport.robot, teleport.to); },
       .spawn = [this](const Spawn& spawn) { return this->spawn(spawn); },
       .remove = [this](const Remove& remove) { return this->remove(remove); }}));
  if (control_.is_paused() == was_paused) return;
  status_due_ = {};
  loop_.notify();
}

std::string WorldShell::spawn(const Spawn& spawn) {
  std::string refusal = world_.spawn(spawn.robot, spawn.at);
  if (!refusal.empty()) return refusal;
  runtime::Tenure& driver = drivers_[spawn.robot - 1];
  const auto& agents = agents_[spawn.robot - 1];
  // It is awaited in the step that begins now if its agent is known to live. So what an order for a step
  // leads to does not hang on how fast anybody is.
  if (!driver.holder() && !agents.empty()) (void)driver.claim(agents.front());
  barrier_.spawn(spawn.robot, driver.holder().has_value());
  status_due_ = {};
  loop_.notify();
  return "";
}

std::string WorldShell::remove(const Remove& remove) {
  std::string refusal = world_.remove(remove.robot);
  if (!refusal.empty()) return refusal;
  barrier_.remove(remove.robot, std::chrono::steady_clock::now());
  commands_[remove.robot - 1].reset();
  radio_due_[remove.robot - 1] = false;
  status_due_ = {};
  loop_.notify();
  return "";
}

void WorldShell::reply(const std::vector<Outcome>& outcomes) {
  for (const Outcome& outcome : outcomes) {
    runtime::log_outcome(outcome);
    msg::ControlReply reply = runtime::to_reply(outcome, session_);
    if (!replies_.write(reply)) ++tallies_.refused_writes;
  }
}

}  // namespace caravan::world
