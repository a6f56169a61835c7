// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "idl/stamp.hpp"
#include "worldPubSubTypes.h"

/// The types of idl/world.idl under their short names: ground truth, never for an agent.
namespace caravan_interfaces::msg {

namespace ItemEvent_Constants = dds_::ItemEvent_Constants;
namespace WorldStatus_Constants = dds_::WorldStatus_Constants;

using RobotTruth = dds_::RobotTruth_;
using ContactEpisode = dds_::ContactEpisode_;
using ItemEvent = dds_::ItemEvent_;
using WorldTruth = dds_::WorldTruth_;
using RadioStep = dds_::RadioStep_;
using WorldStatus = dds_::WorldStatus_;
using RadioStatus = dds_::RadioStatus_;
using RunCredit = dds_::RunCredit_;

using WorldTruthPubSubType = dds_::WorldTruth_PubSubType;
using RadioStepPubSubType = dds_::RadioStep_PubSubType;
using WorldStatusPubSubType = dds_::WorldStatus_PubSubType;
using RadioStatusPubSubType = dds_::RadioStatus_PubSubType;
using RunCreditPubSubType = dds_::RunCredit_PubSubType;

}  // namespace caravan_interfaces::msg
