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

/// Simulated time since the session began. It comes with the inputs; the core never asks a clock.
using Time = std::chrono::nanoseconds;

/// A position in frame W (x east, y north), metres.
using Point = Eigen::Vector2d;

/// Robots are numbered from 1; 0 is nobody.
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

/// What goes over the air: at most MTU bytes on one channel. A frame does not say who sent it; its contents
/// may claim so.
struct Frame {
  Channel channel;
  std::vector<std::uint8_t> bytes;
  bool operator==(const Frame&) const = default;
};

/// A frame as its receiver gets it.
struct ReceivedFrame {
  Channel channel;
  std::vector<std::uint8_t> bytes;
  double signal_strength_dbm = std::numeric_limits<double>::quiet_NaN();  ///< NaN: the radio does not say
};

using robot_model::kSonarCount;

/// One sensor frame. A real that is not known now is NaN.
struct Sensors {
  std::array<double, kSonarCount>
      sonar_range_m{};  ///< along the axis of each sonar from its face; +inf: no echo (REP-117)
  std::array<double, kSonarCount> sonar_age_s{};  ///< how old each range is
  Point p_WB{0.0, 0.0};                           ///< GPS: the robot's base in W
  double yaw_WB_rad = 0.0;                        ///< compass: counter-clockwise from east, in (-pi, pi]
  double left_wheel_rad = 0.0;                    ///< wheel angles since the start, forward positive
  double right_wheel_rad = 0.0;
  bool holding = false;  ///< an item is in the gripper
};

/// What one step gets to know: the time, the sensors and every frame that arrived since the last step, in
/// order.
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

using caravan::Activity;  ///< what this step's time goes to
using caravan::Mode;      ///< has the robot a path?
using caravan::Origin;    ///< where its first path came from

/// One communication attempt, from stopping to resuming.
struct Exchange {
  RobotId partner;
  std::uint16_t session = 0;  ///< number chosen by the primary; 0 when it was never learned
  bool primary = false;
  bool completed = false;
  Time began{0};
  Time ended{0};
};

/// Something worth a line in the run's event list, named in lower_snake_case.
struct Event {
  const char* name = "";
  std::string detail;  ///< key=value pairs
};

/// What the agent says of itself for observers. Sent when something in it changed; `path` only when the path
/// did.
struct Report {
  Mode mode = Mode::kExplore;
  Activity activity = Activity::kIdle;
  Origin origin = Origin::kNone;
  bool towards_destination = false;    ///< direction of travel along the path
  std::uint32_t trips = 0;             ///< pick-ups so far
  std::uint64_t malformed_frames = 0;  ///< heard so far that are not of the protocol
  bool path_changed = false;
  std::vector<Point> path;          ///< from the source to the destination; meaningful when path_changed
  std::vector<Exchange> exchanges;  ///< ended in this step
  std::vector<Event> events;        ///< of this step
};

/// What one step decides.
struct Outputs {
  Wheels wheels;
  bool gripper_closed = false;
  Channel tuned;              ///< the channel it listens on from now
  std::vector<Frame> frames;  ///< sent now, in order
  bool reports = false;       ///< `report` holds something new
  Report report;
};

}  // namespace caravan::agent
