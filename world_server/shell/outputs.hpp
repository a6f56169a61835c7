// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "idl/clock_types.hpp"
#include "idl/control_types.hpp"
#include "idl/robot_types.hpp"
#include "idl/world_types.hpp"
#include "runtime/bus/bus.hpp"
#include "world_server/control/control.hpp"
#include "world_server/shell/tallies.hpp"
#include "world_server/world.hpp"

namespace caravan::world {

/// The topics that the world writes. Counts the samples that DDS does not accept.
class Outputs {
 public:
  Outputs(const WorldConfig& config, std::uint64_t session, Time period, runtime::Bus& bus);

  /// Writes the clock and the sensor readings of each robot.
  /// @param radio_due  by robot: whether it must also wait for the radio's frame of this step
  /// @param sensing    increased by the time that sensing took
  void sensors(World& world, Time stamp, const std::vector<bool>& radio_due,
               std::chrono::nanoseconds& sensing);
  /// Writes true poses, contacts and items, and the members of the step.
  /// @param reported  robots that reported when the bodies moved last
  /// @param last      no step follows
  void truth(const World& world, std::span<const std::uint32_t> members,
             std::span<const std::uint32_t> reported, Time stamp, bool last);
  void status(caravan_interfaces::msg::WorldStatus& status);
  void replies(const std::vector<Outcome>& outcomes);

  [[nodiscard]] std::uint64_t refused() const { return refused_; }

 private:
  void count(bool taken) { refused_ += taken ? 0 : 1; }

  std::uint64_t session_;
  Time period_;
  std::uint64_t refused_ = 0;
  caravan_interfaces::msg::SensorFrame frame_;
  caravan_interfaces::msg::WorldTruth truth_;
  std::vector<runtime::Writer<caravan_interfaces::msg::SensorFramePubSubType>> sensors_;  // [0] is robot 1
  runtime::Writer<caravan_interfaces::msg::WorldTruthPubSubType> truths_;
  runtime::Writer<rosgraph_msgs::msg::ClockPubSubType> clock_;
  runtime::Writer<caravan_interfaces::msg::WorldStatusPubSubType> statuses_;
  runtime::Writer<caravan_interfaces::msg::ControlReplyPubSubType> replies_;
};

}  // namespace caravan::world
