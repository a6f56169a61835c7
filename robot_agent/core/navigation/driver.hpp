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

/// What came between the robot and its goal in a step.
enum class Obstruction : std::uint8_t {
  kNone,
  kRobot,     ///< something ahead and a WAIT: it gives way
  kObstacle,  ///< something ahead that sends no WAIT: it stands, the task decides
  kTouch      ///< it does not move although it should: it frees itself
};

struct Motion {
  Wheels wheels;
  Activity activity = Activity::kDriving;
  Obstruction obstruction = Obstruction::kNone;
  bool drove_forward = false;  ///< with kTouch: what it touches is in front of it
};

/// What a Driver goes by.
struct DriverSettings {
  Body body;
  Driving driving;
  MeetingRule meeting;
  Manoeuvres manoeuvres;
  Recovery recovery;
  KeepClear keep_clear;
  Passage passage;
};

/// Brings the robot to a goal past what is in the way.
///
///   state       | way free | robot ahead        | obstacle ahead        | does not move      | manoeuvre over
///   ------------+----------+--------------------+-----------------------+--------------------+---------------
///   Steering    | steer    | Manoeuvring (rule) | stand, tell kObstacle | Manoeuvring (free) | -
///   Manoeuvring | continue | continue           | continue              | Manoeuvring (free) | Steering
///
/// Below it lies keep_clear(). Steering and kept by it for long is: a robot ahead, when robots are the
/// reason; Manoeuvring (free) and kObstacle, when a surface is.
class Driver {
 public:
  explicit Driver(const DriverSettings& settings);

  [[nodiscard]] Motion drive_to(const Point& goal_W, const Perception& seen, pure::Random& random);
  /// Goes round the obstacle between the robot and the goal; to be called after kObstacle.
  void go_round_towards(const Point& goal_W, const Perception& seen, pure::Random& random);
  /// Backs off a little on the way that it came, which is free, before it turns.
  void back_off();
  /// The robot stands in this step. A manoeuvre under way goes on afterwards.
  [[nodiscard]] Motion stand(Activity activity, Time now);

  /// How the robot moved when it was told last, from what its wheels had been told until then.
  [[nodiscard]] const Twist& twist() const { return twist_; }

  /// Driving freely, not giving way.
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
