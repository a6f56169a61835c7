// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <string>

#include "runtime/pure/one_line.hpp"

namespace caravan::runtime {

/// The text of an exception that foreign code has thrown, as part of one line. It may have none.
[[nodiscard]] inline std::string text_of(const std::exception& thrown) {
  const char* text = thrown.what();
  return text == nullptr ? "(without a text)" : pure::one_line(text);
}

}  // namespace caravan::runtime
