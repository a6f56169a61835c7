// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "experiment/metrics/observation.hpp"

/// Observations written by hand, for tests of what an observer computes from them.
namespace caravan::experiment::test {

inline constexpr Time kStep = std::chrono::milliseconds{32};

/// Robots 1, 2, ... at the given places, all members of the step.
inline Observation at(Time stamp, const std::vector<Place>& places) {
  Observation observation;
  observation.stamp = stamp;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto robot = static_cast<std::uint32_t>(i + 1);
    observation.poses.push_back({.robot = robot, .place = places[i], .yaw_rad = 0.0});
    observation.members.push_back(robot);
  }
  return observation;
}

inline AgentReport doing(std::uint32_t robot, Activity activity) {
  AgentReport report;
  report.robot = robot;
  report.activity = activity;
  return report;
}

inline Observation with(Observation observation, AgentReport report) {
  observation.agent_reports.push_back(std::move(report));
  return observation;
}

}  // namespace caravan::experiment::test
