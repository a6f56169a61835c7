// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>

#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// A message for the operator; the shell logs it.
struct Notice {
  enum class Weight : std::uint8_t { kInfo, kWarning };
  Weight weight = Weight::kInfo;
  std::string text;
  std::string about = {};  ///< the thing whose state it reports, such as "position"; empty: an event
};

/// A duration for notices, such as "0.4 s".
[[nodiscard]] inline std::string in_seconds(Time time) {
  std::array<char, 32> text{};
  const bool tenths = time % std::chrono::milliseconds{100} == Time{0} || time >= std::chrono::seconds{1};
  std::snprintf(text.data(), text.size(), tenths ? "%.1f s" : "%.2f s", seconds(time));
  return text.data();
}

}  // namespace caravan::bridge
