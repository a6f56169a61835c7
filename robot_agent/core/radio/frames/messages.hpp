// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <variant>

#include "robot_agent/core/types.hpp"

/// What robots say to each other. docs/protocol.md is normative; section numbers refer to it.
namespace caravan::agent {

/// Whether the sender of a WAIT can be paired with. All but kFree show as BUSY.
enum class Engagement : std::uint8_t {
  kFree,
  kNegotiating,  ///< stands on the common channel, waiting for `partner`
  kInSession,    ///< listens to the private channel that it shares with `partner`
  kAway          ///< with nobody, and not to be paired with now
};

/// Whole millimetres in frame W.
struct GridPoint {
  std::int32_t x_mm = 0;
  std::int32_t y_mm = 0;
  bool operator==(const GridPoint&) const = default;
};

/// Where the sender of a WAIT is and how it moves, so that others keep clear of what their sonars do not see.
struct Whereabouts {
  GridPoint at;                  ///< its base, by its own GPS
  std::int16_t yaw_mrad = 0;     ///< in W, -3142 .. 3142
  std::int16_t speed_mmps = 0;   ///< of its base, forward positive
  std::int16_t turn_mradps = 0;  ///< counter-clockwise positive
  bool operator==(const Whereabouts&) const = default;
};

/// Presence: "here I am".
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

/// The secondary takes it.
struct AcceptAck {
  RobotId from;
  RobotId to;
  std::uint16_t session = 0;
  bool operator==(const AcceptAck&) const = default;
};

enum class Refusal : std::uint8_t {
  kBusy,     ///< engaged with another robot, or resting: soon is fine
  kDeclined  ///< not for a while
};

/// No. Answers an ACCEPT, or a WAIT whose sender waits for the sender of this.
struct Reject {
  RobotId from;
  RobotId to;
  std::uint16_t session = 0;  ///< of the ACCEPT that it answers; 0: it answers a WAIT
  Refusal refusal = Refusal::kBusy;
  bool operator==(const Reject&) const = default;
};

/// A part of the sender's path, and how much of the receiver's path it holds.
struct PathFragment {
  RobotId from;
  RobotId to;
  std::uint16_t session = 0;
  std::uint16_t total = 0;  ///< points of the sender's whole path; 0: it gives none; never 1
  std::uint16_t first = 0;  ///< index of points[0]
  bool has_heard = false;   ///< at least one fragment of this session has reached the sender
  std::uint16_t holds = 0;  ///< so many points of the receiver's path, counted from its first without a gap
  std::vector<GridPoint> points;  ///< may be empty: an acknowledgement only
  bool operator==(const PathFragment&) const = default;
};

/// Both paths have crossed: the sender holds the receiver's and knows that the receiver holds its own.
struct End {
  RobotId from;
  RobotId to;
  std::uint16_t session = 0;
  bool operator==(const End&) const = default;
};

using Message = std::variant<Wait, Accept, AcceptAck, Reject, PathFragment, End>;

}  // namespace caravan::agent
