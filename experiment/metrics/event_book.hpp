// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiment/metrics/observation.hpp"

namespace caravan::experiment {

/// A row of events.csv.
struct EventRow {
  Time stamp{0};
  std::uint32_t robot = 0;
  std::string event;
  std::string detail;
};

/// Turns observations into rows of events.csv; docs/outputs.md lists the events.
class EventBook {
 public:
  /// Robots are numbered 1 .. robots; reports of others are ignored.
  explicit EventBook(std::uint32_t robots) : members_(robots) {}

  /// @pre stamps never go back
  [[nodiscard]] std::vector<EventRow> observe(const Observation& observation);

 private:
  void add_membership(const Observation& observation, std::vector<EventRow>& rows);

  std::vector<bool> members_;  // [0] is robot 1
  bool seen_members_ = false;
};

}  // namespace caravan::experiment
