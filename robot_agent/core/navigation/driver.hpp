// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "robot_agent/core/navigation/avoidance.hpp"
#include "robot_agent/core/navigation/forward_view.hpp"
#include "robot_agent/core/navigation/keep_clear.hpp"
#include "robot_agent/core/navigation/stuck.hpp"
#include "robot_agent/core/navigation/twist.hpp"
#include "runtime/pure/random.hpp"

namespace caravan::agent {

/// What blocked the robot in a step.
enum class Obstruction : std::uint8_t {
  kNone,
  kRobot,     ///< another robot ahead: this one gives way
  kObstacle,  ///< an echo ahead without a WAIT: the robot stands, and the task reacts
  kTouch      ///< no movement despite commands: the robot frees itself
};

struct Motion {
  Wheels wheels;
  Activity activity = Activity::kDriving;
  Obstruction obstruction = Obstruction::kNone;
  bool drove_forward = false;  ///< with kTouch: the contact is in front of the robot
};

struct DriverSettings {
  Body body;
  Driving driving;
  MeetingRule meeting;
  Manoeuvres manoeuvres;
  Recovery recovery;
  KeepClear keep_clear;
  Passage passage;
};

/// Drives the robot to a goal, around robots and obstacles.
///
///   state       | way free | robot ahead        | obstacle ahead   | stuck              | manoeuvre over
///   ------------+----------+--------------------+------------------+--------------------+---------------
///   Steering    | steer    | Manoeuvring (rule) | stand, kObstacle | Manoeuvring (free) | -
///   Manoeuvring | continue | continue           | continue         | Manoeuvring (free) | Steering
///
/// keep_clear() filters all commands. If it changes them by Recovery::held_mps or more for longer than
/// Recovery::held_time, a manoeuvre skips its current leg. In Steering, if robots are the reason, this counts
/// as a robot ahead; if a surface is, the driver reports kObstacle, and from the second time at one place
/// also frees itself.
class Driver {
 public:
  explicit Driver(const DriverSettings& settings);

  [[nodiscard]] Motion drive_to(const Point& goal_W, const Perception& seen, pure::Random& random);
  /// Starts a manoeuvre round the obstacle between the robot and the goal; call after kObstacle.
  void go_round_towards(const Point& goal_W, const Perception& seen, pure::Random& random);
  /// Starts a manoeuvre that backs off along the way that the robot came, before it turns.
  void back_off();
  /// Stands in this step. A manoeuvre in progress continues afterwards.
  [[nodiscard]] Motion stand(Activity activity, Time now);

  /// Estimated twist at the last command, from the previous commands.
  [[nodiscard]] const Twist& twist() const { return twist_; }

  /// True when no manoeuvre is in progress.
  [[nodiscard]] bool is_steering() const { return std::holds_alternative<Steering>(state_); }

 private:
  struct Steering {};
  struct Manoeuvring {
    Performance performance;
  };
  [[nodiscard]] Motion steer(const Point& goal_W, const Perception& seen, pure::Random& random);
  [[nodiscard]] Motion approach(const Point& goal_W, const Perception& seen, pure::Random& random);
  void meet(const std::optional<Meeting>& meeting, const Point& goal_W, const Perception& seen,
            pure::Random& random);
  void free(const Point& goal_W, const Perception& seen, int attempt, pure::Random& random);
  [[nodiscard]] Allowed allow(const Wheels& wanted, const Perception& seen) const;
  void tell(const Wheels& wheels, Time now);
  [[nodiscard]] bool is_held(const Wheels& wanted, const Wheels& allowed, Time now);
  [[nodiscard]] bool is_hopeless(const Perception& seen) const;
  [[nodiscard]] int attempts_at(const Perception& seen);

  DriverSettings settings_;
  std::variant<Steering, Manoeuvring> state_;
  StuckMonitor monitor_;
  ForwardView view_;
  Wheels last_wheels_;
  Twist twist_;
  Time told_{0};
  std::optional<Time> held_since_;
  Point last_trouble_at_{0.0, 0.0};
  Time last_trouble_{-std::chrono::hours{1}};
  int attempts_ = 0;
};

}  // namespace caravan::agent
