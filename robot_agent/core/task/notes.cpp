// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/task/notes.hpp"

#include <array>
#include <cstdio>

namespace caravan::agent {

std::string in_detail(const char* key, double value) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "%s=%.2f", key, value);
  return text.data();
}

}  // namespace caravan::agent
