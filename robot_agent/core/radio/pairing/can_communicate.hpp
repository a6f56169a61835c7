// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "robot_agent/core/radio/settings.hpp"

namespace caravan::agent {

/// What this robot remembers of one other.
struct Contact {
  RobotId robot;
  Time again_from{0};        ///< not to be paired with before
  Time next_reject_from{0};  ///< no REJECT to it before
};

/// Whom this robot has dealt with: the paper's commHistory, and holds after failures. Sorted by robot.
class Contacts {
 public:
  [[nodiscard]] const Contact* find(RobotId robot) const;
  /// Not to be paired with before `moment`; never shortens.
  void avoid_until(RobotId robot, Time moment);
  /// True at most once for each robot in a period.
  [[nodiscard]] bool may_reject(RobotId robot, Time now, Time period);

 private:
  Contact& at(RobotId robot);
  std::vector<Contact> contacts_;
};

/// Algorithm 5 with the three modes: may this robot pair with that one now?
///
/// Nobody before SharingSettings::starts and nobody in mode none; EXPLORE with EXPLORE never; in partial mode
/// TRANSPORT with TRANSPORT never; nobody within recontact_after of a completed exchange with it, or on hold.
[[nodiscard]] bool can_communicate(const SharingSettings& sharing, const Contacts& contacts, Mode own,
                                   RobotId partner, Mode partners, Time now);

/// The channel that only these two robots use: 1 + (pair index mod (channel_count - 1)), with the pair index
/// hi (hi - 1) / 2 + lo. Distinct for all pairs of ids up to 1447 at 2^20 channels.
/// @pre channel_count >= 2
[[nodiscard]] Channel private_channel(RobotId one, RobotId other, std::uint32_t channel_count);

}  // namespace caravan::agent
