// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/task/carrier.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "robot_agent/core/navigation/exploration.hpp"
#include "robot_agent/core/task/arrival.hpp"

namespace caravan::agent {
namespace {

// A longer step was an exchange, without driving.
constexpr Time kLongestStep = std::chrono::milliseconds{200};

/// From the centre of a touched obstacle: a little more than shortcuts keep, so that the robot does not stop
/// beside it.
double keeps_from_touched_m(const Passage& passage, const ObstacleMemory& obstacles, double room_m) {
  return 0.5 * passage.corridor_m + obstacles.margin_m + room_m;
}

}  // namespace

Carrier::Carrier(const CarrierSettings& settings, Path path, const Point& p_WB)
    : settings_{settings},
      route_{settings.following, std::move(path), false, p_WB},
      refusals_{settings.smoothing.alike_m, settings.smoothing.touch_room_m},
      gripper_{settings.task.gripper_patience},
      last_smoothed_at_{p_WB},
      best_remaining_m_{std::numeric_limits<double>::infinity()},
      last_wander_{-settings.progress.wander_again} {}

void Carrier::sense(const Perception& seen, Notes& notes) {
  switch (gripper_.sense(seen.holding, seen.now)) {
    case Gripper::Change::kNone:
      break;
    case Gripper::Change::kPickedUp:
      ++trips_;
      notes.add("picked_up", "trip=" + std::to_string(trips_));
      break;
    case Gripper::Change::kNothingThere:
      notes.add("nothing_picked_up");
      break;
    case Gripper::Change::kDelivered:
      notes.add("delivered", "trip=" + std::to_string(trips_));
      break;
    case Gripper::Change::kNotDelivered:
      notes.add("not_delivered");
      break;
  }
}

void Carrier::adopt(Path path, const Point& p_WB) {
  route_.replace(std::move(path), p_WB);
  expect_progress();
}

Motion Carrier::step(const Perception& seen, Driver& driver, pure::Random& random, Notes& notes) {
  refusals_.forget(seen.now);
  if (has_arrived(seen, route_.end(), settings_.task, settings_.body)) arrive(seen, notes);
  if (auto* wandering = std::get_if<Wandering>(&state_)) {
    const bool over =
        seen.distance_to(wandering->began_at) >= wandering->enough_m || seen.now >= wandering->give_up;
    if (!over || !driver.is_steering()) return wander(*wandering, seen, driver, random);
    state_ = Following{};
    route_.rejoin(seen.p_WB);
    expect_progress();
    notes.add("unstuck");
  }
  if (!makes_progress(seen)) {
    wanders_ = seen.now - last_wander_ < settings_.progress.wander_again
                   ? std::min(wanders_ + 1, settings_.progress.wander_doublings)
                   : 0;
    last_wander_ = seen.now;
    state_ = Wandering{seen.p_WB,
                       settings_.progress.wander_m * std::exp2(wanders_),
                       seen.now + settings_.progress.wander_timeout,
                       {}};
    notes.add("no_progress");
    return wander(std::get<Wandering>(state_), seen, driver, random);
  }
  return follow(seen, driver, random, notes);
}

void Carrier::arrive(const Perception& seen, Notes& notes) {
  if (route_.towards_destination()) {
    gripper_.arrive_at_destination(seen.now);
  } else {
    gripper_.arrive_at_source(seen.now);
  }
  const Path before = route_.driven();
  route_.turn_round(seen.p_WB);
  notes.path_changed = notes.path_changed || before != route_.driven();
  state_ = Following{};
  expect_progress();
}

Motion Carrier::follow(const Perception& seen, Driver& driver, pure::Random& random, Notes& notes) {
  const double before = length_m(route_.driven());
  if (route_.advance(seen.p_WB)) {
    notes.path_changed = true;
    notes.add("path_shortened",
              in_detail("from_m", before) + " " + in_detail("to_m", length_m(route_.driven())));
  }
  if (driver.is_steering()) smooth(seen);
  if (!seen.touched_W.empty() &&
      route_.bend_round(
          seen.touched_W,
          keeps_from_touched_m(settings_.passage, settings_.obstacles, settings_.smoothing.bend_room_m),
          seen.p_WB)) {
    expect_progress();
    notes.add("path_bent");
  }
  const Motion motion = driver.drive_to(route_.goal(seen.p_WB), seen, random);
  react(motion.obstruction, seen, driver, random, notes);
  return motion;
}

void Carrier::smooth(const Perception& seen) {
  const Smoothing& smoothing = settings_.smoothing;
  if (seen.distance_to(last_smoothed_at_) < smoothing.interval_m || !route_.may_shorten()) return;
  last_smoothed_at_ = seen.p_WB;
  if (route_.off_path_m(seen.p_WB) > smoothing.on_path_m || route_.provisional_m() > smoothing.provisional_m)
    return;
  const double least =
      route_.is_provisional() ? std::max(smoothing.nested_gain_m, smoothing.gain_m) : smoothing.gain_m;
  const auto shortcut = find_shortcut(
      route_.ahead(), seen, {smoothing.vision_radius_m, least, settings_.passage, settings_.body}, refusals_);
  if (!shortcut) return;
  route_.shorten(seen.p_WB, shortcut->candidate, settings_.recording.spacing_m, smoothing.merge_m);
  expect_progress();
}

void Carrier::react(Obstruction obstruction, const Perception& seen, Driver& driver, pure::Random& random,
                    Notes& notes) {
  const bool stands =
      obstruction == Obstruction::kObstacle || (obstruction == Obstruction::kTouch && !seen.robot_near);
  if (!stands) return;
  if (obstruction == Obstruction::kTouch) {
    const Point front = seen.p_WB + settings_.body.ahead_m * direction(seen.yaw_WB_rad);
    refusals_.touched(front, seen.now + settings_.smoothing.pause);
  }
  if (route_.is_provisional()) {
    const Route::Ends blocked = route_.restore(seen.p_WB);
    refusals_.refuse(blocked.from, blocked.to, seen.now + settings_.smoothing.pause);
    notes.add("shortcut_restored");
    if (obstruction == Obstruction::kObstacle) driver.back_off();
    expect_progress();
  } else if (obstruction == Obstruction::kObstacle) {
    driver.go_round_towards(route_.goal(seen.p_WB), seen, random);
  }
}

Motion Carrier::wander(Wandering& state, const Perception& seen, Driver& driver, pure::Random& random) {
  const bool wants_another =
      !state.location || seen.distance_to(*state.location) < settings_.exploration.reached_m;
  if (wants_another && driver.is_steering())
    state.location =
        new_location_to_explore(seen, settings_.exploration, settings_.passage, settings_.body, random);
  Motion motion = driver.drive_to(state.location.value_or(seen.p_WB), seen, random);
  if (motion.obstruction != Obstruction::kNone) state.location.reset();
  motion.activity = Activity::kAvoiding;
  return motion;
}

bool Carrier::makes_progress(const Perception& seen) {
  const double remaining = route_.remaining_m(seen.p_WB);
  if (remaining < best_remaining_m_ - settings_.progress.least_m) {
    best_remaining_m_ = remaining;
    without_progress_ = Time{0};
  } else {
    without_progress_ += std::min(seen.now - last_step_, kLongestStep);
  }
  last_step_ = seen.now;
  return without_progress_ < settings_.progress.timeout;
}

void Carrier::expect_progress() {
  best_remaining_m_ = std::numeric_limits<double>::infinity();
  without_progress_ = Time{0};
}

}  // namespace caravan::agent
