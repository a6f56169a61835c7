// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "idl/control_types.hpp"
#include "runtime/pure/agenda.hpp"

namespace caravan::runtime {

/// The reply to the requester of an order.
[[nodiscard]] caravan_interfaces::msg::ControlReply to_reply(const pure::Outcome& outcome,
                                                             std::uint64_t session);

/// Logs a line for an order that is done or refused. A scheduled order is logged when it is done.
void log_outcome(const pure::Outcome& outcome);

}  // namespace caravan::runtime
