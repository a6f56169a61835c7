// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "robot_agent/core/body.hpp"
#include "robot_agent/core/navigation/settings.hpp"
#include "robot_agent/core/sensing/perception.hpp"

namespace caravan::agent {

/// Turn in place to a heading in W.
struct TurnTo {
  double yaw_WB_rad = 0.0;
};
/// Drive straight; a negative distance is backwards. Ends early when the way is not free.
struct Go {
  double distance_m = 0.0;
};
/// Turn to a heading in W while driving, until so far away. Ends early when the way is not free.
struct Veer {
  double yaw_WB_rad = 0.0;
  double distance_m = 0.0;
};
/// Stand.
struct Pause {
  Time duration{0};
};
using Leg = std::variant<TurnTo, Go, Veer, Pause>;

/// A short sequence of blind movements, each with a deadline.
using Manoeuvre = std::vector<Leg>;

/// A manoeuvre under way.
class Performance {
 public:
  explicit Performance(Manoeuvre legs) : legs_{std::move(legs)} {}

  /// What the wheels do now; nothing: the manoeuvre is over.
  [[nodiscard]] std::optional<Wheels> step(const Perception& seen, const Manoeuvres& settings,
                                           const Driving& driving, const Body& body);
  /// Leaves the current leg: it cannot be done.
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
  bool begun_ = false;  // the current leg
  Point leg_began_at_{0.0, 0.0};
  Time leg_began_{0};
  Time leg_gives_up_{0};
};

}  // namespace caravan::agent
