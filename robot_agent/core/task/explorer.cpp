// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/task/explorer.hpp"

#include "robot_agent/core/navigation/exploration.hpp"
#include "robot_agent/core/navigation/sees_destination.hpp"
#include "robot_agent/core/task/arrival.hpp"

namespace caravan::agent {
Explorer::Explorer(const ExplorerSettings& settings)
    : settings_{settings}, record_{settings.task.source, settings.recording}, state_{Searching{}} {}

Motion Explorer::step(const Perception& seen, Driver& driver, pure::Random& random) {
  record_.visit(seen.p_WB, seen.yaw_WB_rad);
  if (std::holds_alternative<Searching>(state_) && seen.now >= looks_again_) {
    if (const auto destination = look_out(seen)) {
      state_ = Approaching{*destination, seen.now};
    }
  }
  if (auto* approaching = std::get_if<Approaching>(&state_)) {
    return approach(*approaching, seen, driver, random);
  }
  return search(std::get<Searching>(state_), seen, driver, random);
}

Motion Explorer::search(Searching& state, const Perception& seen, Driver& driver, pure::Random& random) {
  const bool wants_another = !state.location ||
                             seen.distance_to(*state.location) < settings_.exploration.reached_m ||
                             seen.now >= state.give_up;
  if (wants_another && driver.is_steering()) {
    state = {new_location_to_explore(seen, settings_.exploration, settings_.passage, settings_.body, random),
             seen.now + settings_.exploration.location_timeout};
  }
  const Motion motion = driver.drive_to(state.location.value_or(seen.p_WB), seen, random);
  if (motion.obstruction != Obstruction::kNone) state.location.reset();
  return motion;
}

Motion Explorer::approach(Approaching& state, const Perception& seen, Driver& driver, pure::Random& random) {
  const Point destination = state.destination;
  if (has_arrived(seen, destination, settings_.task, settings_.body)) {
    found_ = record_.finished_at(seen.p_WB, destination);
    return driver.stand(Activity::kDriving, seen.now);
  }
  if (seen.robot_near || look_out(seen)) state.last_seen = seen.now;
  const Motion motion = driver.drive_to(destination, seen, random);
  const bool blocked =
      motion.obstruction == Obstruction::kObstacle || motion.obstruction == Obstruction::kTouch;
  if (blocked || seen.now - state.last_seen > settings_.exploration.out_of_sight) look_away(seen.now);
  return motion;
}

std::optional<Point> Explorer::look_out(const Perception& seen) const {
  return sees_destination(seen, settings_.task, settings_.exploration, settings_.passage);
}

void Explorer::look_away(Time now) {
  state_ = Searching{};
  looks_again_ = now + settings_.exploration.look_away;
}

}  // namespace caravan::agent
