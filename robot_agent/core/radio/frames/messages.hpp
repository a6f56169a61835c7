// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <variant>

#include "robot_agent/core/types.hpp"

/// The messages of the radio protocol. docs/protocol.md is normative; section numbers refer to it.
namespace caravan::agent {

/// Whether the sender of a WAIT is available for pairing. All but kFree are shown as BUSY.
enum class Engagement : std::uint8_t {
  kFree,
  kNegotiating,  ///< stands on the common channel and waits for `partner`
  kInSession,    ///< listens to the private channel shared with `partner`
  kAway          ///< has no partner and is not available now
};

/// Whole millimetres in frame W.
struct GridPoint {
  std::int32_t x_mm = 0;
  std::int32_t y_mm = 0;
  bool operator==(const GridPoint&) const = default;
};

/// Position and motion of the sender of a WAIT. Others use it to keep clear of a robot that their sonars do
/// not see.
struct Whereabouts {
  GridPoint at;                  ///< position of its base, by its own GPS
  std::int16_t yaw_mrad = 0;     ///< in W, -3142 .. 3142
  std::int16_t speed_mmps = 0;   ///< of its base, forward positive
  std::int16_t turn_mradps = 0;  ///< counter-clockwise positive
  bool operator==(const Whereabouts&) const = default;
};

/// Presence.
struct Wait {
  RobotId from;
  Mode mode = Mode::kExplore;
  Engagement engagement = Engagement::kFree;
  RobotId partner;  ///< 0 unless kNegotiating or kInSession
  std::optional<Whereabouts> whereabouts{};
  bool operator==(const Wait&) const = default;
};

/// The primary offers a session.
struct Accept {
  RobotId from;
  RobotId to;
  std::uint16_t session = 0;
  Mode mode = Mode::kExplore;  ///< of the sender
  bool operator==(const Accept&) const = default;
};

/// The secondary accepts the session.
struct AcceptAck {
  RobotId from;
  RobotId to;
  std::uint16_t session = 0;
  bool operator==(const AcceptAck&) const = default;
};

enum class Refusal : std::uint8_t {
  kBusy,     ///< engaged with another robot, or resting: may be tried again soon
  kDeclined  ///< not to be tried again for a longer time
};

/// Refuses an ACCEPT, or a WAIT whose sender waits for this robot.
struct Reject {
  RobotId from;
  RobotId to;
  std::uint16_t session = 0;  ///< of the refused ACCEPT; 0: refuses a WAIT
  Refusal refusal = Refusal::kBusy;
  bool operator==(const Reject&) const = default;
};

/// A part of the sender's path, and an acknowledgement of the receiver's path.
struct PathFragment {
  RobotId from;
  RobotId to;
  std::uint16_t session = 0;
  std::uint16_t total = 0;        ///< points of the sender's whole path; 0: none; never 1
  std::uint16_t first = 0;        ///< index of points[0]
  bool has_heard = false;         ///< the sender has received a fragment of this session
  std::uint16_t holds = 0;        ///< points of the receiver's path held without a gap, from the first on
  std::vector<GridPoint> points;  ///< may be empty: acknowledgement only
  bool operator==(const PathFragment&) const = default;
};

/// The exchange is complete: the sender holds the receiver's path and knows that the receiver holds its own.
struct End {
  RobotId from;
  RobotId to;
  std::uint16_t session = 0;
  bool operator==(const End&) const = default;
};

using Message = std::variant<Wait, Accept, AcceptAck, Reject, PathFragment, End>;

}  // namespace caravan::agent
