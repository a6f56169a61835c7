// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/navigation/driver.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "robot_agent/core/navigation/steering.hpp"

namespace caravan::agent {
namespace {

// Bound on the time step of the motor model: any twist is reached in less.
constexpr Time kLongestStep = std::chrono::seconds{1};

Perception without_surfaces(Perception seen) {
  seen.surfaces.clear();
  return seen;
}

}  // namespace

Driver::Driver(const DriverSettings& settings) : settings_{settings} {}

Motion Driver::stand(Activity activity, Time now) {
  monitor_.reset();
  held_since_.reset();
  tell({}, now);
  return {{}, activity, Obstruction::kNone};
}

bool Driver::is_hopeless(const Perception& seen) const {
  return attempts_ >= static_cast<int>(settings_.recovery.attempts) &&
         seen.now - last_trouble_ < settings_.recovery.again_time &&
         seen.distance_to(last_trouble_at_) < settings_.recovery.again_m;
}

int Driver::attempts_at(const Perception& seen) {
  const bool again = seen.now - last_trouble_ < settings_.recovery.again_time &&
                     seen.distance_to(last_trouble_at_) < settings_.recovery.again_m;
  attempts_ = again ? attempts_ + 1 : 0;
  last_trouble_ = seen.now;
  last_trouble_at_ = seen.p_WB;
  return attempts_;
}

Motion Driver::drive_to(const Point& goal_W, const Perception& seen, pure::Random& random) {
  Motion motion = approach(goal_W, seen, random);
  const auto [allowed, surface_near] =
      is_hopeless(seen) ? allow(motion.wheels, without_surfaces(seen)) : allow(motion.wheels, seen);
  if (is_held(motion.wheels, allowed, seen.now)) {
    held_since_.reset();
    if (auto* manoeuvring = std::get_if<Manoeuvring>(&state_)) {
      manoeuvring->performance.skip();
    } else if (surface_near) {
      // The task may know a way round; from the second time at this place the robot frees itself first.
      if (const int attempt = attempts_at(seen); attempt > 0) free(goal_W, seen, attempt, random);
      motion.obstruction = Obstruction::kObstacle;
    } else {
      motion.obstruction = Obstruction::kRobot;
      meet({}, goal_W, seen, random);
    }
  }
  if (allowed != motion.wheels) motion.activity = Activity::kAvoiding;
  motion.wheels = allowed;
  tell(allowed, seen.now);
  return motion;
}

Allowed Driver::allow(const Wheels& wanted, const Perception& seen) const {
  return keep_clear(wanted, twist_, seen, settings_.keep_clear, settings_.driving, settings_.body);
}

void Driver::tell(const Wheels& wheels, Time now) {
  const double passed = std::chrono::duration<double>(std::min(now - told_, kLongestStep)).count();
  twist_ = approaching(twist_, twist_of(last_wheels_, settings_.body.track_m), passed,
                       settings_.driving.acceleration);
  last_wheels_ = wheels;
  told_ = now;
}

bool Driver::is_held(const Wheels& wanted, const Wheels& allowed, Time now) {
  const double difference =
      std::abs(wanted.left_mps - allowed.left_mps) + std::abs(wanted.right_mps - allowed.right_mps);
  if (difference < settings_.recovery.held_mps) {
    held_since_.reset();
    return false;
  }
  if (!held_since_) held_since_ = now;
  return now - *held_since_ > settings_.recovery.held_time;
}

void Driver::meet(const std::optional<Meeting>& meeting, const Point& goal_W, const Perception& seen,
                  pure::Random& random) {
  const Encounter encounter{seen,
                            settings_.manoeuvres,
                            settings_.passage.corridor_m,
                            seen.bearing_to(goal_W),
                            random.unit(),
                            attempts_at(seen),
                            meeting};
  state_ = Manoeuvring{Performance{turn_slightly_left(encounter)}};
}

void Driver::free(const Point& goal_W, const Perception& seen, int attempt, pure::Random& random) {
  state_ = Manoeuvring{Performance{free_itself({seen, settings_.manoeuvres, settings_.passage.corridor_m,
                                                seen.bearing_to(goal_W), random.unit(), attempt})}};
}

Motion Driver::approach(const Point& goal_W, const Perception& seen, pure::Random& random) {
  const bool stuck =
      monitor_.update(seen, last_wheels_, settings_.recovery, settings_.body.track_m) || seen.touched;
  auto* manoeuvring = std::get_if<Manoeuvring>(&state_);
  if (stuck && manoeuvring && last_wheels_.left_mps < 0.0 && last_wheels_.right_mps < 0.0) {
    manoeuvring->performance.skip();  // contact behind as well: stop backing off
  } else if (stuck) {
    const bool drove_forward = last_wheels_.left_mps > 0.0 && last_wheels_.right_mps > 0.0;
    free(goal_W, seen, attempts_at(seen), random);
    return {{}, Activity::kAvoiding, Obstruction::kTouch, drove_forward};
  }
  if (manoeuvring) {
    if (const auto wheels =
            manoeuvring->performance.step(seen, settings_.manoeuvres, settings_.driving, settings_.body)) {
      return {*wheels, Activity::kAvoiding, Obstruction::kNone};
    }
    state_ = Steering{};
  }
  return steer(goal_W, seen, random);
}

Motion Driver::steer(const Point& goal_W, const Perception& seen, pure::Random& random) {
  const Body& body = settings_.body;
  const Driving& driving = settings_.driving;
  const MeetingRule& rule = settings_.meeting;
  const double bearing = seen.bearing_to(goal_W);
  const auto [ahead, closing] = view_.update(seen, free_ahead_m(seen.around, body), rule);
  const bool facing = std::abs(bearing) < driving.facing_rad;
  const bool in_the_way = ahead < driving.too_close_m || (ahead < rule.echo_m && closing > rule.closing_mps);
  const bool somebody = seen.robot_near && seen.robots.empty();  // without a reported position
  const auto meeting =
      facing ? find_meeting({bearing, driving.cruise_mps}, seen, rule, body, settings_.keep_clear.robots_m)
             : std::nullopt;
  if (meeting || (facing && somebody && in_the_way)) {
    meet(meeting, goal_W, seen, random);
    return {{}, Activity::kAvoiding, Obstruction::kRobot};
  }
  // Obstacles beyond the goal do not count.
  const double needed =
      std::min(driving.too_close_m, std::max(driving.goal_room_m, seen.distance_to(goal_W)));
  if (facing && free_ahead_m(seen.still, body) < needed) {
    return {{}, Activity::kAvoiding, Obstruction::kObstacle};
  }
  const double steered = facing ? bearing + turn_from_surfaces_rad(seen, driving, body) : bearing;
  return {steer_to(steered, speed_for(ahead, driving), driving, body), Activity::kDriving,
          Obstruction::kNone};
}

void Driver::go_round_towards(const Point& goal_W, const Perception& seen, pure::Random& random) {
  // Keep to one side for four attempts at the same obstacle.
  const int attempt = attempts_at(seen) / 4;
  state_ = Manoeuvring{Performance{go_round({seen, settings_.manoeuvres, settings_.passage.corridor_m,
                                             seen.bearing_to(goal_W), random.unit(), attempt})}};
}

void Driver::back_off() { state_ = Manoeuvring{Performance{{Go{-settings_.recovery.back_off_m}}}}; }

}  // namespace caravan::agent
