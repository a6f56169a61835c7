// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "idl/stamp.hpp"
#include "robotPubSubTypes.h"

/// The types of idl/robot.idl under their short names. On the wire they are called as in the IDL.
namespace caravan_interfaces::msg {

namespace Telemetry_Constants = dds_::Telemetry_Constants;

using SensorFrame = dds_::SensorFrame_;
using RobotCommand = dds_::RobotCommand_;
using RadioFrame = dds_::RadioFrame_;
using RadioTransmit = dds_::RadioTransmit_;
using ReceivedFrame = dds_::ReceivedFrame_;
using RadioReceive = dds_::RadioReceive_;
using PathPoint = dds_::PathPoint_;
using ExchangeReport = dds_::ExchangeReport_;
using AgentEvent = dds_::AgentEvent_;
using Telemetry = dds_::Telemetry_;

using SensorFramePubSubType = dds_::SensorFrame_PubSubType;
using RobotCommandPubSubType = dds_::RobotCommand_PubSubType;
using RadioTransmitPubSubType = dds_::RadioTransmit_PubSubType;
using RadioReceivePubSubType = dds_::RadioReceive_PubSubType;
using TelemetryPubSubType = dds_::Telemetry_PubSubType;

}  // namespace caravan_interfaces::msg
