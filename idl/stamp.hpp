// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

#include "stamp.h"

namespace builtin_interfaces::msg {
using Time = dds_::Time_;
}  // namespace builtin_interfaces::msg

namespace caravan::idl {

/// Simulated time as it stands on the wire, and back.
[[nodiscard]] inline builtin_interfaces::msg::Time to_wire(std::chrono::nanoseconds time) {
  builtin_interfaces::msg::Time stamp;
  stamp.sec(static_cast<std::int32_t>(time.count() / 1'000'000'000));
  stamp.nanosec(static_cast<std::uint32_t>(time.count() % 1'000'000'000));
  return stamp;
}
[[nodiscard]] inline std::chrono::nanoseconds to_time(const builtin_interfaces::msg::Time& stamp) {
  return std::chrono::seconds{stamp.sec()} + std::chrono::nanoseconds{stamp.nanosec()};
}

}  // namespace caravan::idl
