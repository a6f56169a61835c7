// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/navigation/driver.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "robot_agent/core/navigation/steering.hpp"

namespace caravan::agent {
namespace {

using namespace std::chrono_literals;

constexpr double kFacing_rad = 0.5;  // something ahead matters when the goal is ahead, too
// Trouble is the same trouble again when it comes this soon and this near.
constexpr Time kAgain = 15s;
constexpr double kSamePlace_m = 1.0;
constexpr double kBacksOff_m = 0.4;
// A robot ahead that comes no nearer than this drives in the same direction: follow it.
constexpr double kComes_mps = 0.2;

}  // namespace

Driver::Driver(const Config& config, AvoidanceRule when_meeting)
    : config_{config}, when_meeting_{when_meeting} {}

Motion Driver::moving(Wheels wheels, Activity activity, Obstruction obstruction) {
  last_wheels_ = wheels;
  return {wheels, activity, obstruction};
}

Motion Driver::stand(Activity activity) {
  monitor_.reset();
  return moving({}, activity, Obstruction::kNone);
}

int Driver::attempts_at(const Perception& seen) {
  const bool again = seen.now - last_trouble_ < kAgain && seen.distance_to(last_trouble_at_) < kSamePlace_m;
  attempts_ = again ? attempts_ + 1 : 0;
  last_trouble_ = seen.now;
  last_trouble_at_ = seen.p_WB;
  return attempts_;
}

Motion Driver::drive_to(const Point& goal_W, const Perception& seen, pure::Random& random) {
  if (monitor_.update(seen, last_wheels_, config_)) {
    state_ = Manoeuvring{
        Performance{free_itself({seen, config_, seen.bearing_to(goal_W), random.unit(), attempts_at(seen)})}};
    return moving({}, Activity::kAvoiding, Obstruction::kTouch);
  }
  if (auto* manoeuvring = std::get_if<Manoeuvring>(&state_)) {
    if (const auto wheels = manoeuvring->performance.step(seen, config_)) {
      return moving(*wheels, Activity::kAvoiding, Obstruction::kNone);
    }
    state_ = Steering{};
  }
  return steer(goal_W, seen, random);
}

Motion Driver::steer(const Point& goal_W, const Perception& seen, pure::Random& random) {
  const double bearing = seen.bearing_to(goal_W);
  const auto [ahead, closing] = watch_.update(seen, free_ahead_m(seen, config_));
  const bool facing = std::abs(bearing) < kFacing_rad;
  const bool in_the_way = ahead < config_.too_close_m || (ahead < config_.meeting_m && closing > kComes_mps);
  if (facing && seen.robot_near && in_the_way) {
    state_ =
        Manoeuvring{Performance{when_meeting_({seen, config_, bearing, random.unit(), attempts_at(seen)})}};
    return moving({}, Activity::kAvoiding, Obstruction::kRobot);
  }
  // Something beyond the goal is not in the way.
  const double needed = std::min(config_.too_close_m, std::max(0.15, seen.distance_to(goal_W)));
  if (facing && ahead < needed) return moving({}, Activity::kAvoiding, Obstruction::kObstacle);
  const double leaning = facing ? bearing + lean_rad(seen, config_) : bearing;
  return moving(steer_to(leaning, speed_for(ahead, config_), config_), Activity::kDriving,
                Obstruction::kNone);
}

void Driver::go_round_towards(const Point& goal_W, const Perception& seen, pure::Random& random) {
  // The same side again while it is the same obstacle.
  const int attempt = attempts_at(seen) / 4;
  state_ =
      Manoeuvring{Performance{go_round({seen, config_, seen.bearing_to(goal_W), random.unit(), attempt})}};
}

void Driver::back_off() { state_ = Manoeuvring{Performance{{Go{-kBacksOff_m}}}}; }

}  // namespace caravan::agent
