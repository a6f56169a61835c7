// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/navigation/avoidance.hpp"
#include "robot_agent/core/path/merge.hpp"

namespace caravan::agent {

/// The two decisions that traffic management will want to take otherwise. Plain functions: same arguments,
/// same answer.
struct Rules {
  /// How to give way to another robot.
  AvoidanceRule when_meeting = turn_slightly_left;
  /// The path to use from now, of one's own and one received (mode full). Both have the same ends.
  Path (*choose_path)(const Path& own, const Path& received) = merge;
};

}  // namespace caravan::agent
