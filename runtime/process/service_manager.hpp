// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace caravan::runtime {

/// Tells the service manager (systemd, Type=notify) the state of this process: "READY=1", "STOPPING=1",
/// "WATCHDOG=1".
///
/// A datagram to the socket named by $NOTIFY_SOCKET, see sd_notify(3). Does nothing without that socket or
/// when nobody reads it.
void tell_service_manager(const std::string& state);

/// Interval at which the service manager expects "WATCHDOG=1", from $WATCHDOG_USEC; none: it does not.
[[nodiscard]] std::optional<std::chrono::microseconds> watchdog_period();

}  // namespace caravan::runtime
