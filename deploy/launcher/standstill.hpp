// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "idl/world_types.hpp"
#include "runtime/process/loop.hpp"

namespace caravan::deploy {

/// Notices that a run stands still and says what it waits for. Somebody may have paused it, and a hung robot
/// may be waited for as long as the scenario says; a world that says nothing for a minute is given up, and so
/// is a run in which no robot has been left for a minute: others may have taken their place until then.
class Standstill {
 public:
  explicit Standstill(runtime::WallTime began) : stepped_{began}, told_{began}, heard_{began} {}

  void note_step(runtime::WallTime now) { stepped_ = now; }
  void note_world(runtime::WallTime now) { heard_ = now; }
  /// A line every five seconds while no step comes.
  /// @param world  its newest status, none: not heard yet
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
