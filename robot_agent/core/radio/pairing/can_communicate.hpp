// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "robot_agent/core/radio/settings.hpp"

namespace caravan::agent {

/// What is remembered of one other robot.
struct Contact {
  RobotId robot;
  Time again_from{0};        ///< no pairing with it before this
  Time next_reject_from{0};  ///< no REJECT to it before this
};

/// The robots that this one has dealt with: the paper's commHistory, and holds after failures. Sorted by
/// robot.
class Contacts {
 public:
  [[nodiscard]] const Contact* find(RobotId robot) const;
  /// Forbids pairing with a robot before `moment`; never shortens an earlier hold.
  void avoid_until(RobotId robot, Time moment);
  /// True at most once per period and robot; a true result starts the period.
  [[nodiscard]] bool may_reject(RobotId robot, Time now, Time period);

 private:
  Contact& at(RobotId robot);
  std::vector<Contact> contacts_;
};

/// Algorithm 5 with the three modes: whether this robot may pair with `partner` now.
///
/// Not before SharingSettings::starts; not in mode none; never EXPLORE with EXPLORE; in partial mode not
/// TRANSPORT with TRANSPORT; not within recontact_after of a completed exchange with `partner`, nor during a
/// hold.
[[nodiscard]] bool can_communicate(const SharingSettings& sharing, const Contacts& contacts, Mode own,
                                   RobotId partner, Mode partners, Time now);

/// The private channel of a pair: 1 + (pair index mod (channel_count - 1)), with the pair index hi (hi - 1) /
/// 2 + lo. All pairs of ids up to 1447 have different channels at 2^20 channels.
/// @pre channel_count >= 2
[[nodiscard]] Channel private_channel(RobotId one, RobotId other, std::uint32_t channel_count);

}  // namespace caravan::agent
