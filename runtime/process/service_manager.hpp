// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace caravan::runtime {

/// Tells the service manager (systemd, Type=notify) how this process is: "READY=1", "STOPPING=1",
/// "WATCHDOG=1".
///
/// A datagram to the socket that $NOTIFY_SOCKET names, see sd_notify(3). Nothing happens where there is none,
/// or when nobody reads it.
void tell_service_manager(const std::string& state);

/// How often the service manager wants to hear "WATCHDOG=1", from $WATCHDOG_USEC; none: it does not.
[[nodiscard]] std::optional<std::chrono::microseconds> watchdog_period();

}  // namespace caravan::runtime
