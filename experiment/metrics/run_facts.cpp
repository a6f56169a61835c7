// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/run_facts.hpp"

namespace caravan::experiment {

Outcome outcome_of(const RunFacts& facts, const RunEnd& end, std::uint32_t items_delivered, Time sim_time) {
  if (!end.failure.empty()) return Outcome::kFailed;
  const bool done = facts.items == 0 ? sim_time >= facts.max_time : items_delivered >= facts.items;
  if (done) return Outcome::kCompleted;
  return end.interrupted ? Outcome::kInterrupted : Outcome::kTimeOver;
}

int exit_code_of(Outcome outcome) {
  if (outcome == Outcome::kCompleted) return 0;
  return outcome == Outcome::kInterrupted ? 130 : 1;
}

}  // namespace caravan::experiment
