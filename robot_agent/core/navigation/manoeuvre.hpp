// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "robot_agent/core/body.hpp"
#include "robot_agent/core/navigation/settings.hpp"
#include "robot_agent/core/sensing/perception.hpp"

namespace caravan::agent {

/// Turn in place to a heading in frame W.
struct TurnTo {
  double yaw_WB_rad = 0.0;
};
/// Drive straight, backwards if the distance is negative. Ends early when the way is blocked.
struct Go {
  double distance_m = 0.0;
};
/// Turn to a heading in frame W while driving, for a distance. Ends early when the way is blocked.
struct Veer {
  double yaw_WB_rad = 0.0;
  double distance_m = 0.0;
};
struct Pause {
  Time duration{0};
};
using Leg = std::variant<TurnTo, Go, Veer, Pause>;

/// A short sequence of movements without regard to the goal, each with a deadline.
using Manoeuvre = std::vector<Leg>;

/// A manoeuvre in progress.
class Performance {
 public:
  explicit Performance(Manoeuvre legs) : legs_{std::move(legs)} {}

  /// Wheel speeds for this step; none: the manoeuvre is over.
  [[nodiscard]] std::optional<Wheels> step(const Perception& seen, const Manoeuvres& settings,
                                           const Driving& driving, const Body& body);
  /// Ends the current leg, because it cannot be completed.
  void skip();

 private:
  [[nodiscard]] std::optional<Wheels> perform(const TurnTo& leg, const Perception& seen,
                                              const Manoeuvres& settings, const Driving& driving,
                                              const Body& body) const;
  [[nodiscard]] std::optional<Wheels> perform(const Go& leg, const Perception& seen,
                                              const Manoeuvres& settings, const Driving& driving,
                                              const Body& body) const;
  [[nodiscard]] std::optional<Wheels> perform(const Veer& leg, const Perception& seen,
                                              const Manoeuvres& settings, const Driving& driving,
                                              const Body& body) const;
  [[nodiscard]] std::optional<Wheels> perform(const Pause& leg, Time now) const;
  Manoeuvre legs_;
  std::size_t current_ = 0;
  bool begun_ = false;  // the current leg has begun
  Point leg_began_at_{0.0, 0.0};
  Time leg_began_{0};
  Time leg_gives_up_{0};
};

}  // namespace caravan::agent
