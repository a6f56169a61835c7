// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/body.hpp"
#include "robot_agent/core/navigation/settings.hpp"
#include "robot_agent/core/path/settings.hpp"
#include "robot_agent/core/radio/settings.hpp"
#include "robot_agent/core/sensing/settings.hpp"
#include "robot_agent/core/task/settings.hpp"

namespace caravan::agent {

/// Settings of one agent, grouped by concern. Agent passes each part to the code that uses it; nothing else
/// takes the whole. Defaults are the values in the paper's text where it gives one.
struct Config {
  RobotId id{1};
  std::uint64_t seed = 1;
  bool robots_are_solid = true;  ///< false: robots pass through one another and never give way
  Task task;
  Progress progress;
  Body body;
  Sonars sonars;
  Passage passage;
  Exploration exploration;
  Driving driving;
  MeetingRule meeting;
  Manoeuvres manoeuvres;
  Recovery recovery;
  KeepClear keep_clear;
  NeighbourMemory neighbours;
  SurfaceMemory surfaces;
  ObstacleMemory obstacles;
  TouchSensing touch;
  EchoLoss vanishing_echo;
  PatienceSettings patience;
  RecordingSettings recording;
  PathFollowing following;
  Smoothing smoothing;
  WaitSettings wait;
  SharingSettings sharing;
  Air air;

  bool operator==(const Config&) const = default;
};

}  // namespace caravan::agent
