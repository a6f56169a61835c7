// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "deploy/metrics/observation.hpp"
#include "robotPubSubTypes.h"
#include "runtime/bus/bus.hpp"
#include "runtime/process/loop.hpp"
#include "worldPubSubTypes.h"

namespace caravan::deploy {

/// The launcher's ears on the bus: turns truth and telemetry into observations that miss nothing.
///
/// It gives the world credit, so the world never runs more than 256 steps ahead of it. Each truth names the
/// robots that have reported in the step before; a step is given out when their reports are here too, however
/// they overtook each other or were lost and sent again. For a robot that is lost nobody waits, for any other
/// ten seconds at most.
class Observer {
 public:
  /// What has been heard since the last look.
  struct News {
    std::vector<Observation> observations;  ///< whole steps, in order
    bool last_seen = false;                 ///< the run is decided and its last observation was among them
    std::optional<caravan_interfaces::msg::WorldStatus> world;  ///< the newest
    std::optional<caravan_interfaces::msg::RadioStatus> radio;
    double agents_compute_s = 0.0;
  };

  /// @param name  by which the world knows this observer
  /// @param loop  notified when enough has arrived to be worth a look
  Observer(const runtime::BusConfig& bus, const std::string& name, std::uint32_t robots, runtime::Loop& loop);
  ~Observer();
  Observer(const Observer&) = delete;
  Observer& operator=(const Observer&) = delete;

  /// Takes what has arrived.
  [[nodiscard]] News look();
  /// Tells the world that everything up to `stamp` is handled.
  void give_credit(Time stamp);

 private:
  struct Step {
    Observation seen;
    std::vector<std::uint32_t> reported;  ///< in the step before
  };

  /// False: a sample of a session that is over.
  [[nodiscard]] bool follow_session(std::uint64_t session);
  void on_truth(const caravan_interfaces::msg::WorldTruth& truth);
  void on_telemetry(std::uint32_t robot, const caravan_interfaces::msg::Telemetry& telemetry);
  /// Gives out the steps whose reports are all here.
  void give_out();
  /// A robot whose report of the oldest step is still on its way.
  [[nodiscard]] std::optional<std::uint32_t> missing_report() const;
  [[nodiscard]] bool may_give_out();

  runtime::Loop& loop_;
  std::string name_;
  std::mutex mutex_;
  std::uint64_t session_ = 0;
  std::deque<Step> steps_;                           // not given out yet, the newest last
  std::vector<std::uint32_t> members_;               // by the newest truth
  std::optional<runtime::WallTime> waiting_since_;   // for a report
  std::multimap<Time, AgentReport> reports_;         // of steps that are not given out
  std::map<std::uint32_t, Time> heard_until_;        // each robot's newest report
  std::map<std::uint32_t, double> agent_compute_s_;  // of every robot that has been heard
  News news_;
  runtime::Bus bus_;
  runtime::Writer<caravan_interfaces::msg::RunCreditPubSubType> credit_;
};

}  // namespace caravan::deploy
