// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "idl/control_types.hpp"
#include "runtime/pure/agenda.hpp"

namespace caravan::runtime {

/// What became of an order, as the requester is told it.
[[nodiscard]] caravan_interfaces::msg::ControlReply to_reply(const pure::Outcome& outcome,
                                                             std::uint64_t session);

/// A line for what is done or refused. What waits for its step is told when it is done.
void log_outcome(const pure::Outcome& outcome);

}  // namespace caravan::runtime
