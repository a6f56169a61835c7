// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace caravan::bridge {

/// Something that an operator wants to know; the shell logs it.
struct Notice {
  enum class Weight : std::uint8_t { kInfo, kWarning };
  Weight weight = Weight::kInfo;
  std::string text;
};

}  // namespace caravan::bridge
