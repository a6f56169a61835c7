// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "experiment/metrics/observation.hpp"
#include "idl/robot_types.hpp"
#include "idl/world_types.hpp"
#include "runtime/process/loop.hpp"

namespace caravan::deploy {

/// Combines truths and the robots' reports into complete steps.
///
/// Each truth names the robots that reported in the previous step. A step is released when these reports have
/// arrived too, in any order and even if they were lost and sent again. It does not wait for a lost robot,
/// and for any other at most ten seconds of wall time. Not thread-safe.
class StepBook {
 public:
  /// False: a sample of a session that is over.
  [[nodiscard]] bool follow_session(std::uint64_t session);
  /// These ignore samples of a session that is over, and reports of another version.
  void add(const caravan_interfaces::msg::WorldTruth& truth);
  void add(std::uint32_t robot, const caravan_interfaces::msg::Telemetry& telemetry);

  /// Number of complete steps.
  [[nodiscard]] std::size_t whole_steps() const { return whole_.size(); }
  /// Takes the complete steps, in order.
  [[nodiscard]] std::vector<experiment::Observation> take();
  [[nodiscard]] std::uint64_t session() const { return session_; }
  /// Wall time spent by all agents, according to their latest reports.
  [[nodiscard]] double agents_compute_s() const;

 private:
  struct Step {
    experiment::Observation seen;
    std::vector<std::uint32_t> reported;  ///< in the previous step
  };
  void give_out();
  /// A robot whose report of the oldest step has not arrived.
  [[nodiscard]] std::optional<std::uint32_t> missing_report() const;
  [[nodiscard]] bool may_give_out();

  std::uint64_t session_ = 0;
  std::deque<Step> steps_;                                            // not complete yet, the latest last
  std::vector<experiment::Observation> whole_;                        // not taken yet
  std::vector<std::uint32_t> members_;                                // according to the latest truth
  std::optional<runtime::WallTime> waiting_since_;                    // for a report
  std::multimap<experiment::Time, experiment::AgentReport> reports_;  // of steps that are not complete
  std::map<std::uint32_t, experiment::Time> heard_until_;             // each robot's latest report
  std::set<std::uint32_t> refused_;                  // robots whose refused report was logged
  std::map<std::uint32_t, double> agent_compute_s_;  // of every robot that has reported
};

}  // namespace caravan::deploy
