// SPDX-License-Identifier: Apache-2.0
// Control requests to the running world, and its replies.
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

void WorldShell::on_control(const msg::ControlRequest& request) {
  if (is_for_the_radio(request)) return;
  const std::lock_guard lock{mutex_};
  if (request.session() != session_) {
    outputs_.replies(
        {{request.requester(), request.id(), Outcome::Kind::kRefused, 0, "that session is over"}});
    return;
  }
  const auto outcome =
      control_.ask({request.requester(), request.id(), request.at_step(), to_action(request)},
                   lockstep_.first_not_begun(world_.step()));
  if (!outcome) return;
  outputs_.replies({*outcome});
  progress();
  loop_.notify();  // a deadline and the status may have changed
}

void WorldShell::reach_boundary() {
  const bool was_paused = control_.is_paused();
  const double speed = control_.speed();
  outputs_.replies(control_.reach(
      world_.step(),
      {.teleport = [this](const Teleport& teleport) { return world_.place(teleport.robot, teleport.to); },
       .spawn = [this](const Spawn& spawn) { return this->spawn(spawn); },
       .remove = [this](const Remove& remove) { return this->remove(remove); }}));
  if (control_.speed() != speed) pace_.change(std::chrono::steady_clock::now(), control_.speed());
  if (control_.is_paused() != was_paused) status_changed();
}

std::string WorldShell::spawn(const Spawn& spawn) {
  std::string refusal = world_.spawn(spawn.robot, spawn.at);
  if (!refusal.empty()) return refusal;
  auto& [driver, agents] = drivers_[spawn.robot - 1];
  // The step that begins now waits for it if its agent is known to be running. The effect of an order for a
  // step therefore does not depend on the speed of any process.
  if (!driver.holder() && !agents.empty()) (void)driver.claim(agents.front());
  barrier_.spawn(spawn.robot, driver.holder().has_value());
  status_changed();
  return "";
}

std::string WorldShell::remove(const Remove& remove) {
  std::string refusal = world_.remove(remove.robot);
  if (!refusal.empty()) return refusal;
  barrier_.remove(remove.robot, std::chrono::steady_clock::now());
  inputs_.drop(remove.robot);
  inputs_.radio_due[remove.robot - 1] = false;
  status_changed();
  return "";
}

void WorldShell::status_changed() {
  status_due_ = {};
  loop_.notify();
}

}  // namespace caravan::world
