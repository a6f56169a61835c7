// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <caravan/types.hpp>
#include <chrono>
#include <compare>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "runtime/pure/robot_model.hpp"

namespace caravan::agent {

/// Simulated time since the session began. It is part of the inputs; the core reads no clock.
using Time = std::chrono::nanoseconds;

/// A position in frame W (x east, y north), metres.
using Point = Eigen::Vector2d;

/// Robots are numbered from 1; 0 means no robot.
struct RobotId {
  std::uint16_t value = 0;
  auto operator<=>(const RobotId&) const = default;
};

/// A radio channel, an opaque index. Channel 0 is the common channel.
struct Channel {
  std::uint32_t value = 0;
  auto operator<=>(const Channel&) const = default;
};
inline constexpr Channel kCommonChannel{0};

/// A radio frame: at most MTU bytes on one channel. It has no sender field; its contents may name a sender.
struct Frame {
  Channel channel;
  std::vector<std::uint8_t> bytes;
  bool operator==(const Frame&) const = default;
};

/// A frame with its reception data.
struct ReceivedFrame {
  Channel channel;
  std::vector<std::uint8_t> bytes;
  double signal_strength_dbm = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not reported
};

using robot_model::kSonarCount;

/// One sensor frame. NaN: the value is unknown.
struct Sensors {
  std::array<double, kSonarCount>
      sonar_range_m{};  ///< along the axis of each sonar from its face; +inf: no echo (REP-117)
  std::array<double, kSonarCount> sonar_age_s{};  ///< age of each range
  Point p_WB{0.0, 0.0};                           ///< GPS: the robot's base in W
  double yaw_WB_rad = 0.0;                        ///< compass: counter-clockwise from east, in (-pi, pi]
  double left_wheel_rad = 0.0;                    ///< wheel angles since the start, forward positive
  double right_wheel_rad = 0.0;
  bool holding = false;  ///< an item is in the gripper
};

/// Inputs of one step: the time, the sensors, and all frames that arrived since the previous step, in order
/// of arrival.
struct Inputs {
  Time now{0};
  Sensors sensors;
  std::vector<ReceivedFrame> heard;
};

/// Rim speeds of the two driven wheels, m/s, forward positive.
struct Wheels {
  double left_mps = 0.0;
  double right_mps = 0.0;
  bool operator==(const Wheels&) const = default;
};

using caravan::Activity;  ///< what the robot does in this step
using caravan::Mode;      ///< whether the robot has a path
using caravan::Origin;    ///< where its first path came from

/// One communication attempt, from stopping until driving on.
struct Exchange {
  RobotId partner;
  std::uint16_t session = 0;  ///< chosen by the primary; 0: never received
  bool primary = false;
  bool completed = false;
  Time began{0};
  Time ended{0};
};

/// An entry in the run's list of events. Names are lower_snake_case.
struct Event {
  const char* name = "";
  std::string detail;  ///< key=value pairs
};

/// Status of the agent for observers. Sent when it has changed; `path` is included only when the path has
/// changed.
struct Report {
  Mode mode = Mode::kExplore;
  Activity activity = Activity::kIdle;
  Origin origin = Origin::kNone;
  bool towards_destination = false;    ///< direction of travel along the path
  std::uint32_t trips = 0;             ///< number of pick-ups
  std::uint64_t malformed_frames = 0;  ///< received frames that are not of the protocol
  bool path_changed = false;
  std::vector<Point> path;          ///< from the source to the destination; valid if path_changed
  std::vector<Exchange> exchanges;  ///< attempts that ended in this step
  std::vector<Event> events;        ///< events of this step
};

/// Outputs of one step.
struct Outputs {
  Wheels wheels;
  bool gripper_closed = false;
  Channel tuned;              ///< the channel it listens on from now on
  std::vector<Frame> frames;  ///< to be sent now, in order
  bool reports = false;       ///< `report` contains something new
  Report report;
};

}  // namespace caravan::agent
