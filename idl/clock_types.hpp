// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "clockPubSubTypes.h"
#include "idl/stamp.hpp"

/// The type of idl/clock.idl under its short name.
namespace rosgraph_msgs::msg {

using Clock = dds_::Clock_;

using ClockPubSubType = dds_::Clock_PubSubType;

}  // namespace rosgraph_msgs::msg
