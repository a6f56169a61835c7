// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// What a controller is given in each step, and what it decides. Units are in the names. Frame W is the
/// world: x east, y north. Frame B is the robot: on the floor below the middle of the axle, x forward, y
/// left.
namespace caravan {

/// Simulated time since the run began. On a real robot, time since its bridge started.
using Time = std::chrono::nanoseconds;

/// A position in frame W.
struct Position {
  double x_m = 0.0;
  double y_m = 0.0;
};

inline constexpr std::size_t kSonarCount = 16;

/// What the robot measures. A number that is not known now is NaN.
struct Sensors {
  std::array<double, kSonarCount> sonar_range_m{};  ///< from the face of each sonar; +inf: no echo (REP-117)
  std::array<double, kSonarCount> sonar_age_s{};    ///< how old each range is
  Position position;                                ///< of B in W, by GPS
  double yaw_rad = 0.0;                             ///< by compass: counter-clockwise from east, in (-pi, pi]
  double left_wheel_rad = 0.0;                      ///< wheel angles since the start, forward positive
  double right_wheel_rad = 0.0;
  bool holding = false;  ///< an item is in the gripper
};

/// A frame that the radio has received. It does not say who sent it; its bytes may claim so.
struct ReceivedFrame {
  std::uint32_t channel = 0;
  std::vector<std::uint8_t> bytes;
  double signal_strength_dbm = std::numeric_limits<double>::quiet_NaN();  ///< NaN: the radio does not say
};

/// What one step is given.
struct Inputs {
  Time now{0};
  Sensors sensors;
  std::vector<ReceivedFrame> heard;  ///< since the last step, in the order of arrival
  /// Where the destination is, while the robot sees it. Sight is simulated: by the distance of the robot and
  /// by what its sonars see in between.
  std::optional<Position> destination;
};

/// Limits of one step's Outputs. A step that exceeds one ends the controller; so does a value that is none of
/// its enumeration.
inline constexpr std::size_t kMostFrames = 1000;
inline constexpr std::size_t kMostFrameBytes = std::size_t{1} << 20U;  ///< of all its frames
inline constexpr std::size_t kMostPathPoints = 65535;
inline constexpr double kFarthest_m = 1e6;  ///< of a coordinate of a reported path, positive or negative
inline constexpr std::size_t kMostExchanges = 100;
inline constexpr std::size_t kMostEvents = 100;
inline constexpr std::size_t kMostEventBytes = 4096;  ///< of the name and the detail of one event

/// A frame to send, of at most Radio::mtu_bytes. The radio drops a longer one.
struct Frame {
  std::uint32_t channel = 0;
  std::vector<std::uint8_t> bytes;
};

/// Something worth a line in the run's list of events.
struct Event {
  std::string name;    ///< in lower_snake_case
  std::string detail;  ///< key=value pairs; UTF-8 without NUL
};

/// One attempt to exchange paths with another robot.
struct Exchange {
  std::uint32_t partner = 0;
  std::uint32_t session = 0;  ///< number that the partners agreed on; 0: none
  bool primary = false;       ///< this robot asked for it
  bool completed = false;
  Time began{0};  ///< from 0 to `ended`
  Time ended{0};  ///< at most Inputs::now
};

enum class Mode : std::uint8_t { kExplore, kTransport };  ///< does the robot know a path?
enum class Activity : std::uint8_t { kIdle, kDriving, kAvoiding, kExchanging };
enum class Origin : std::uint8_t { kNone, kFound, kReceived };  ///< where its first path came from

/// What a controller says of itself. Observers, metrics and records get it; the run does not depend on it. A
/// controller without paths or exchanges leaves those parts as they are.
struct Report {
  Mode mode = Mode::kExplore;
  Activity activity = Activity::kDriving;
  Origin origin = Origin::kNone;
  bool towards_destination = false;    ///< direction of travel along the path
  std::uint32_t trips = 0;             ///< pick-ups so far
  std::uint64_t malformed_frames = 0;  ///< heard so far that were not of its protocol
  /// From the source to the destination. None: as in the report before. At most kMostPathPoints, all finite.
  std::optional<std::vector<Position>> path;
  std::vector<Exchange> exchanges;  ///< ended in this step; at most kMostExchanges
  std::vector<Event> events;        ///< of this step; at most kMostEvents
};

/// What one step decides.
struct Outputs {
  double left_mps = 0.0;  ///< rim speed of each driven wheel, forward positive
  double right_mps = 0.0;
  bool gripper_closed = false;
  std::uint32_t tuned_channel = 0;  ///< the radio listens on it from now; 0 is common to all
  std::vector<Frame> frames;        ///< sent now, in order
  std::optional<Report> report;     ///< when something in it has changed
};

}  // namespace caravan
