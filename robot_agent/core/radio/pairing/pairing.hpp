// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <variant>

#include "robot_agent/core/radio/frames/messages.hpp"
#include "robot_agent/core/radio/settings.hpp"

/// Algorithm 6: the handshake of two robots, and the deadlines that end it. docs/protocol.md, section
/// "Pairing", is normative.
namespace caravan::agent {

/// Drives, and looks for a partner from `rests_until` on.
struct Free {
  Time rests_until{0};
};
/// Primary: stands, sends ACCEPT, waits for ACCEPTACK.
struct Accepting {
  RobotId partner;
  std::uint16_t session = 0;
  Time began{0};
  Time last_heard{0};  ///< last reception from the partner
  Time next_accept{0};
  std::uint32_t accepts_left = 0;
};
/// Secondary: stands, waits for ACCEPT.
struct Awaiting {
  RobotId partner;
  Time began{0};
  Time last_heard{0};
};
/// Stands, listens to the private channel, exchanges paths.
struct InSession {
  RobotId partner;
  std::uint16_t session = 0;
  bool primary = false;
  bool confirmed = false;  ///< the partner is known to be in session too; until then ACCEPTACK is repeated
  Time began{0};           ///< of the attempt
  Time opened{0};          ///< of the session
  Time last_heard{0};
};
/// The exchange is complete. The robot drives on, and repeats END on the private channel in case the partner
/// did not receive it.
struct Lingering {
  RobotId partner;
  std::uint16_t session = 0;
  Time leaves{0};  ///< END is sent until this time
};
using State = std::variant<Free, Accepting, Awaiting, InSession, Lingering>;

/// A WAIT of another robot. `eligible`: can_communicate() allows pairing.
struct WaitHeard {
  Wait wait;
  bool eligible = false;
};
/// An ACCEPT for this robot. `eligible` as above.
struct AcceptHeard {
  Accept accept;
  bool eligible = false;
};
/// An ACCEPTACK for this robot.
struct AcceptAckHeard {
  AcceptAck ack;
};
/// A REJECT for this robot.
struct RejectHeard {
  Reject reject;
};
/// A path fragment for this robot. `crossed`: both robots now hold both paths.
struct FragmentHeard {
  RobotId from;
  std::uint16_t session = 0;
  bool crossed = false;
};
/// An END for this robot. `crossed`: the partner's path is complete here, so END completes the exchange.
struct EndHeard {
  RobotId from;
  std::uint16_t session = 0;
  bool crossed = false;
};
/// The end of a step, after all frames received in it.
struct Tick {};
using PairingEvent =
    std::variant<WaitHeard, AcceptHeard, AcceptAckHeard, RejectHeard, FragmentHeard, EndHeard, Tick>;

/// What to send in this state; at most one frame per step.
enum class Send : std::uint8_t { kNothing, kAccept, kAcceptAck, kFragment, kEnd };

/// A REJECT to send, on the channel that the other robot listens to.
struct Refuse {
  RobotId to;
  std::uint16_t session = 0;
  Refusal refusal = Refusal::kBusy;
  bool on_private_channel = false;
};

/// An attempt that has ended, and how long this partner must not be tried again (0: no hold).
struct Outcome {
  Exchange exchange;
  Time hold{0};
};

struct Decision {
  State next;
  Send send = Send::kNothing;
  std::optional<Refuse> refuse;
  std::optional<Outcome> outcome;
};

/// The state machine.
///
///   state     | WAIT, free and | WAIT that waits | WAIT of my     | ACCEPT for me   | ACCEPTACK | REJECT  | PATH or END
///             | eligible       | for me          | partner        |                 | of mine   | of mine | of mine
///   ----------+----------------+-----------------+----------------+-----------------+-----------+---------+--------------
///   Free      | Accepting or   | the same, or    | (has none)     | InSession, or   | -         | -       | -
///             | Awaiting       | REJECT          |                | REJECT          |           |         |
///   Accepting | -              | REJECT, unless  | Free when it   | REJECT          | InSession | Free    | -
///             |                | of my partner   | is busy        |                 |           |         |
///   Awaiting  | -              | REJECT, unless  | Free when it   | InSession if of | -         | Free    | -
///             |                | of my partner   | is busy        | partner; REJECT |           |         |
///   InSession | -              | -               | -              | -               | -         | Free    | Lingering
///             |                |                 |                |                 |           |         | when crossed
///   Lingering | -              | -               | -              | -               | -         | -       | END: Free
///
///   At the end of a step Accepting sends ACCEPT when one is due; InSession sends ACCEPTACK until confirmed,
///   then PATH; Lingering sends END. Deadlines that lead to Free: accept_attempts * accept_period (Accepting,
///   Awaiting), session_timer (InSession), silence of the partner (all three), leaves (Lingering).
///
/// "-": ignored by design. The higher id is primary (Accepting), the lower one secondary (Awaiting). A WAIT
/// "waits for me" if its sender negotiates or is in session with this robot. An ACCEPT from a lower id is
/// ignored. After a failure a Free robot rests.
class Pairing {
 public:
  /// @param wait_period  longest time between two WAITs of a partner
  Pairing(RobotId id, const SharingSettings& sharing, Time wait_period);

  /// Pure function: equal arguments give equal decisions.
  [[nodiscard]] Decision advance(const State& state, const PairingEvent& event, Time now) const;

 private:
  struct Rules;
  RobotId id_;
  Time accept_period_;
  std::uint32_t accept_attempts_;
  Time session_timer_;
  Time silence_;
  Time linger_;
  Time rest_;
  Time hold_;
};

/// What the WAIT of a robot in this state reports.
struct Presence {
  Engagement engagement = Engagement::kFree;
  RobotId partner;
};
[[nodiscard]] Presence presence_in(const State& state, Time now);
[[nodiscard]] bool stands_still(const State& state);

}  // namespace caravan::agent
