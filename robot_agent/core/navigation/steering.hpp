// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/body.hpp"
#include "robot_agent/core/navigation/settings.hpp"
#include "robot_agent/core/sensing/perception.hpp"

namespace caravan::agent {

/// Rim speeds for a speed of the base and a rate of turn (positive to the left). If a wheel would exceed its
/// limit, both are scaled down by the same factor.
[[nodiscard]] Wheels wheels_for(double speed_mps, double turn_radps, const Body& body);

/// Turns in place towards a bearing.
[[nodiscard]] Wheels turn_to(double bearing_rad, const Driving& driving, const Body& body);

/// Drives towards a bearing: the larger it is, the slower; in place above Driving::turn_in_place_rad.
[[nodiscard]] Wheels steer_to(double bearing_rad, double speed_mps, const Driving& driving, const Body& body);

/// Free distance ahead of the body along a bearing, metres; 0 in contact.
[[nodiscard]] double free_ahead_m(const Surroundings& around, const Body& body, double bearing_rad = 0.0);
/// Like free_ahead_m(), but without surfaces beside the body: a robot close to a wall can drive along it.
[[nodiscard]] double free_alongside_m(const Surroundings& around, const Body& body, double bearing_rad = 0.0);
/// Like free_alongside_m(), behind the body.
[[nodiscard]] double free_behind_m(const Surroundings& around, const Body& body);

/// Change of heading away from a surface close beside the robot, positive to the left. Walls end in corners,
/// which return no echo: clearance from the wall is clearance from its corner.
[[nodiscard]] double turn_from_surfaces_rad(const Perception& seen, const Driving& driving, const Body& body);

/// Cruise speed, or slower when something is ahead.
[[nodiscard]] double speed_for(double free_ahead_m, const Driving& driving);

}  // namespace caravan::agent
