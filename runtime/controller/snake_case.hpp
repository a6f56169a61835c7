// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string_view>

namespace caravan::runtime {

/// Whether a name is a letter from a to z, followed by such letters, digits and underlines.
[[nodiscard]] inline bool is_lower_snake_case(std::string_view name) {
  const auto is_letter = [](char one) { return one >= 'a' && one <= 'z'; };
  return !name.empty() && is_letter(name.front()) && std::ranges::all_of(name, [&](char one) {
    return is_letter(one) || (one >= '0' && one <= '9') || one == '_';
  });
}

}  // namespace caravan::runtime
