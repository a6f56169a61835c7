// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "controlPubSubTypes.h"
#include "idl/stamp.hpp"

/// The types of idl/control.idl under their short names.
namespace caravan_interfaces::msg {

namespace ControlRequest_Constants = dds_::ControlRequest_Constants;
namespace ControlReply_Constants = dds_::ControlReply_Constants;

using ControlRequest = dds_::ControlRequest_;
using ControlReply = dds_::ControlReply_;

using ControlRequestPubSubType = dds_::ControlRequest_PubSubType;
using ControlReplyPubSubType = dds_::ControlReply_PubSubType;

}  // namespace caravan_interfaces::msg
