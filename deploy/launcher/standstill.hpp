// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "idl/world_types.hpp"
#include "runtime/process/loop.hpp"

namespace caravan::deploy {

/// Detects that a run does not step, and reports what it waits for. A paused run, and one that waits for a
/// hung robot, may wait as long as the scenario allows. A world that is silent for a minute is given up, and
/// so is a run that has had no robot for a minute: until then other robots may join.
class Standstill {
 public:
  explicit Standstill(runtime::WallTime began) : stepped_{began}, told_{began}, heard_{began} {}

  void note_step(runtime::WallTime now) { stepped_ = now; }
  void note_world(runtime::WallTime now) { heard_ = now; }
  /// A line every five seconds while there is no step.
  /// @param world  its latest status; none: not received yet
  [[nodiscard]] std::optional<std::string> say(
      runtime::WallTime now, const std::optional<caravan_interfaces::msg::WorldStatus>& world);
  /// Why the run is over; none: it is not.
  [[nodiscard]] std::optional<std::string> give_up(
      runtime::WallTime now, const std::optional<caravan_interfaces::msg::WorldStatus>& world) const;

 private:
  runtime::WallTime stepped_;
  runtime::WallTime told_;
  runtime::WallTime heard_;
};

}  // namespace caravan::deploy
