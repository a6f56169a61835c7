// SPDX-License-Identifier: Apache-2.0
#include "deploy/launcher/listen.hpp"

#include <memory>
#include <utility>

#include "idl/robot_types.hpp"
#include "idl/world_types.hpp"

namespace caravan::deploy {
namespace msg = caravan_interfaces::msg;
using runtime::ParticipantId;

void listen(runtime::Bus& bus, std::uint32_t robots, Listener listener) {
  const auto to = std::make_shared<const Listener>(std::move(listener));
  for (std::uint32_t robot = 1; robot <= robots; ++robot) {
    bus.reader<msg::TelemetryPubSubType>(
        idl::kTelemetry, robot,
        [to, robot](const msg::Telemetry& sample, const ParticipantId&) { to->telemetry(robot, sample); });
  }
  bus.reader<msg::WorldTruthPubSubType>(
      idl::kTruth, 0, [to](const msg::WorldTruth& sample, const ParticipantId&) { to->truth(sample); });
  bus.reader<msg::WorldStatusPubSubType>(
      idl::kWorldStatus, 0,
      [to](const msg::WorldStatus& sample, const ParticipantId&) { to->world(sample); });
  bus.reader<msg::RadioStatusPubSubType>(
      idl::kRadioStatus, 0,
      [to](const msg::RadioStatus& sample, const ParticipantId&) { to->radio(sample); });
}

}  // namespace caravan::deploy
