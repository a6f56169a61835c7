// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/navigation/keep_clear.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "robot_agent/core/body.hpp"
#include "robot_agent/core/navigation/steering.hpp"

namespace caravan::agent {
namespace {

// Number of poses in a predicted trajectory; it spans this times KeepClear::prediction_step_s.
constexpr std::size_t kMoments = 7;
constexpr double kNothing_m = 1e-3;  // a smaller violation is rounding
// Shares of the wanted speed and of slow_mps that are tried as candidates.
constexpr double kOfWanted = 0.6;
constexpr double kOfSlow = 0.5;

using Trajectory = std::array<Pose, kMoments>;

/// Poses of a robot whose wheels get a new command and then brake.
Trajectory predicted_trajectory(Pose pose, Twist now, const Twist& told, const KeepClear& settings,
                                const Acceleration& limits) {
  const double step = settings.prediction_step_s;
  Trajectory trajectory;
  double seconds = 0.0;
  for (Pose& there : trajectory) {
    const Twist then = approaching(now, seconds < settings.command_s ? told : Twist{}, step, limits);
    const double turned = 0.5 * step * (now.angular_radps + then.angular_radps);
    pose.p_WB += 0.5 * step * (now.linear_mps + then.linear_mps) * direction(pose.yaw_WB_rad + 0.5 * turned);
    pose.yaw_WB_rad += turned;
    now = then;
    seconds += step;
    there = pose;
  }
  return trajectory;
}

/// Distances between two robots: between their axles, and between their bodies where these could touch.
struct Spacing {
  double axles_m = 0.0;
  double bodies_m = 0.0;
};

Spacing spacing(const Pose& one, const Pose& other, double swept_m, const KeepClear& settings,
                const Body& body) {
  const double axles = (one.p_WB - other.p_WB).norm();
  const double apart = axles - 2.0 * swept_m;  // between the circles that the bodies sweep when they turn
  return {axles, apart > settings.robots_m ? apart : distance_m(one, other, body)};
}

/// The robots near by with their predicted trajectories, and the surfaces near by.
class Scene {
 public:
  Scene(const Perception& seen, const Twist& now, const KeepClear& settings, const Acceleration& limits,
        const Body& body)
      : self_{seen.p_WB, seen.yaw_WB_rad},
        now_{now},
        settings_{settings},
        limits_{limits},
        body_{body},
        swept_m_{std::hypot(std::max(body.ahead_m, body.length_m - body.ahead_m), 0.5 * body.width_m)} {
    for (const Neighbour& robot : seen.robots) {
      if (seen.distance_to(robot.p_WB) > settings_.robots_within_m) continue;
      const Pose there{robot.p_WB, robot.yaw_WB_rad};
      const Twist moves{robot.speed_mps, robot.turn_radps};
      const Spacing spaced = spacing(self_, there, swept_m_, settings_, body_);
      const double keeps = settings_.robots_m;
      const double turns = 2.0 * swept_m_ + keeps;
      const Spacing wanted{std::min(turns, spaced.axles_m),
                           spaced.bodies_m < keeps ? settings_.kept_share * spaced.bodies_m : keeps};
      others_.push_back({wanted, predicted_trajectory(there, moves, moves, settings_, limits_)});
    }
    double nearest = settings_.surfaces_m;
    for (const Point& at : seen.surfaces) {
      const double apart = signed_distance_m(self_, at, body_);
      if (apart <= -settings_.inside_m) continue;
      nearest = std::min(nearest, apart);
      surfaces_.push_back(
          {at, std::min(settings_.surfaces_m, apart > 0.0 ? settings_.kept_share * apart : apart)});
    }
    if (nearest > settings_.contact_m) return;
    for (Surface& surface : surfaces_) surface.wanted_m = std::min(surface.wanted_m, nearest);
  }

  [[nodiscard]] bool is_empty() const { return others_.empty() && surfaces_.empty(); }

  /// Largest violation along the predicted trajectory; 0: the twist is admissible.
  [[nodiscard]] double violation_m(const Twist& twist) const {
    double most = 0.0;
    const Trajectory trajectory = predict(twist);
    for (const Other& other : others_) {
      for (std::size_t i = 0; i < kMoments; ++i) {
        const Spacing there = spacing(trajectory[i], other.trajectory[i], swept_m_, settings_, body_);
        most = std::max({most, other.wanted.axles_m - there.axles_m,
                         settings_.body_weight * (other.wanted.bodies_m - there.bodies_m)});
      }
    }
    return std::max(most, too_near_to_surfaces_m(trajectory));
  }
  [[nodiscard]] bool comes_near_a_surface(const Twist& twist) const {
    return too_near_to_surfaces_m(predict(twist)) > kNothing_m;
  }

 private:
  struct Surface {
    Point at;
    double wanted_m;
  };
  struct Other {
    Spacing wanted;
    Trajectory trajectory;
  };
  Pose self_;
  Twist now_;
  const KeepClear& settings_;
  const Acceleration& limits_;
  const Body& body_;
  double swept_m_;
  std::vector<Other> others_;
  std::vector<Surface> surfaces_;

  [[nodiscard]] Trajectory predict(const Twist& twist) const {
    return predicted_trajectory(self_, now_, twist, settings_, limits_);
  }
  [[nodiscard]] double too_near_to_surfaces_m(const Trajectory& trajectory) const {
    double most = 0.0;
    for (const Pose& pose : trajectory) {
      for (const Surface& surface : surfaces_) {
        const double reach = swept_m_ + surface.wanted_m;
        if ((surface.at - pose.p_WB).squaredNorm() > reach * reach) continue;
        const double violation = surface.wanted_m - signed_distance_m(pose, surface.at, body_);
        most = std::max(most, settings_.body_weight * violation);
      }
    }
    return most;
  }
};

struct Candidate {
  Twist twist;
  double cost;
};

/// Alternative twists, most similar first. Of two equally similar ones the left one comes first, by the rule
/// for meetings.
std::vector<Candidate> candidates(const Twist& wanted, double slow, const KeepClear& settings) {
  const std::array<double, 6> speeds = {
      wanted.linear_mps, kOfWanted * wanted.linear_mps, slow, kOfSlow * slow, 0.0, -kOfSlow * slow};
  std::vector<double> turns = {wanted.angular_radps, 0.0};
  for (const double turn : settings.turns_radps) turns.insert(turns.end(), {turn, -turn});
  std::vector<Candidate> result;
  result.reserve(speeds.size() * turns.size());
  for (const double speed : speeds) {
    if (std::abs(speed) > std::max(std::abs(wanted.linear_mps), slow)) continue;
    for (const double turn : turns) {
      const double slower = (wanted.linear_mps - speed) / settings.linear_scale_mps;
      const double turned = (turn - wanted.angular_radps) / settings.angular_scale_radps;
      const double against = speed * wanted.linear_mps < 0.0 ? settings.reverse_cost : 0.0;
      const double rightwards = turned < 0.0 ? settings.right_cost : 0.0;
      result.push_back({{speed, turn}, slower * slower + turned * turned + against + rightwards});
    }
  }
  std::ranges::stable_sort(result, {}, &Candidate::cost);
  return result;
}

bool has_room(const Twist& twist, const Perception& seen, const KeepClear& settings, const Body& body) {
  if (twist.linear_mps > 0.0) {
    const double aside =
        std::clamp(settings.arc_s * twist.angular_radps, -settings.arc_limit_rad, settings.arc_limit_rad);
    return free_alongside_m(seen.still, body, aside) > settings.echo_m;
  }
  return twist.linear_mps == 0.0 || free_behind_m(seen.still, body) > settings.echo_m;
}

}  // namespace

Allowed keep_clear(const Wheels& wanted, const Twist& now, const Perception& seen, const KeepClear& settings,
                   const Driving& driving, const Body& body) {
  const Scene scene{seen, now, settings, driving.acceleration, body};
  if (scene.is_empty()) return {wanted};
  const Twist twist = twist_of(wanted, body.track_m);
  double least = scene.violation_m(twist);
  if (least <= kNothing_m) return {wanted};
  const bool surface = scene.comes_near_a_surface(twist);
  Twist best{};
  least = scene.violation_m(best);
  for (const Candidate& candidate : candidates(twist, driving.slow_mps, settings)) {
    if (!has_room(candidate.twist, seen, settings, body)) continue;
    const double violation = scene.violation_m(candidate.twist);
    if (violation <= kNothing_m)
      return {wheels_for(candidate.twist.linear_mps, candidate.twist.angular_radps, body), surface};
    if (violation >= least) continue;
    least = violation;
    best = candidate.twist;
  }
  return {wheels_for(best.linear_mps, best.angular_radps, body), surface};
}

}  // namespace caravan::agent
