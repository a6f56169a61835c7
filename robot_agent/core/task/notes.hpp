// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "robot_agent/core/types.hpp"

namespace caravan::agent {

/// Events and changes of this step, to be reported.
struct Notes {
  std::vector<Event> events;
  bool path_changed = false;
  void add(const char* name, std::string detail = {}) { events.push_back({name, std::move(detail)}); }
};

/// `key=value` with two decimals.
[[nodiscard]] std::string in_detail(const char* key, double value);

}  // namespace caravan::agent
