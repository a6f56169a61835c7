// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/body.hpp"
#include "robot_agent/core/navigation/settings.hpp"
#include "robot_agent/core/sensing/perception.hpp"

namespace caravan::agent {

/// Rim speeds for a speed of the base and a rate of turn (positive to the left), scaled down together to the
/// wheel limit.
[[nodiscard]] Wheels wheels_for(double speed_mps, double turn_radps, const Body& body);

/// Turns towards a bearing in place.
[[nodiscard]] Wheels turn_to(double bearing_rad, const Driving& driving, const Body& body);

/// Drives towards a bearing: the further off it is, the slower; in place when it is far off.
[[nodiscard]] Wheels steer_to(double bearing_rad, double speed_mps, const Driving& driving, const Body& body);

/// Free distance ahead of the body, metres; 0 when something touches it.
[[nodiscard]] double free_ahead_m(const Surroundings& around, const Body& body, double bearing_rad = 0.0);
/// The same, but surfaces beside the body do not count: a robot close beside a wall can drive along it.
[[nodiscard]] double free_alongside_m(const Surroundings& around, const Body& body, double bearing_rad = 0.0);
/// The same behind the body.
[[nodiscard]] double free_behind_m(const Surroundings& around, const Body& body);

/// The change of heading away from a surface close beside the robot, positive to the left. Walls end in
/// corners, which return no echo: a distance to the wall is a distance to its corner.
[[nodiscard]] double turn_from_surfaces_rad(const Perception& seen, const Driving& driving, const Body& body);

/// Cruise, or slow when something is ahead.
[[nodiscard]] double speed_for(double free_ahead_m, const Driving& driving);

}  // namespace caravan::agent
