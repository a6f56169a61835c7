// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "robot_agent/core/types.hpp"

namespace caravan::agent {

/// What the parts of an agent want to be known of this step.
struct Notes {
  std::vector<Event> events;
  bool path_changed = false;
  void add(const char* name, std::string detail = {}) { events.push_back({name, std::move(detail)}); }
};

/// `key=value` with two decimals.
[[nodiscard]] std::string in_detail(const char* key, double value);

}  // namespace caravan::agent
