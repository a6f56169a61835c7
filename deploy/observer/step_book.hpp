// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "experiment/metrics/observation.hpp"
#include "idl/robot_types.hpp"
#include "idl/world_types.hpp"
#include "runtime/process/loop.hpp"

namespace caravan::deploy {

/// Puts truths and what robots report together into whole steps.
///
/// Each truth names the robots that have reported in the step before; a step is given out when their reports
/// are here too, however they overtook each other or were lost and sent again. For a robot that is lost
/// nobody waits, for any other ten seconds of wall time at most. Not for several threads at a time.
class StepBook {
 public:
  /// False: a sample of a session that is over.
  [[nodiscard]] bool follow_session(std::uint64_t session);
  /// These ignore samples of a session that is over, and reports of another version.
  void add(const caravan_interfaces::msg::WorldTruth& truth);
  void add(std::uint32_t robot, const caravan_interfaces::msg::Telemetry& telemetry);

  /// So many whole steps are here.
  [[nodiscard]] std::size_t whole_steps() const { return whole_.size(); }
  /// Takes them, in order.
  [[nodiscard]] std::vector<experiment::Observation> take();
  [[nodiscard]] std::uint64_t session() const { return session_; }
  /// Wall time that all agents have computed, by what they last said.
  [[nodiscard]] double agents_compute_s() const;

 private:
  struct Step {
    experiment::Observation seen;
    std::vector<std::uint32_t> reported;  ///< in the step before
  };
  void give_out();
  /// A robot whose report of the oldest step is still on its way.
  [[nodiscard]] std::optional<std::uint32_t> missing_report() const;
  [[nodiscard]] bool may_give_out();

  std::uint64_t session_ = 0;
  std::deque<Step> steps_;                                            // not whole yet, the newest last
  std::vector<experiment::Observation> whole_;                        // not taken yet
  std::vector<std::uint32_t> members_;                                // by the newest truth
  std::optional<runtime::WallTime> waiting_since_;                    // for a report
  std::multimap<experiment::Time, experiment::AgentReport> reports_;  // of steps that are not whole
  std::map<std::uint32_t, experiment::Time> heard_until_;             // each robot's newest report
  std::map<std::uint32_t, double> agent_compute_s_;                   // of every robot that has been heard
};

}  // namespace caravan::deploy
