// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "deploy/observer/listen.hpp"
#include "deploy/observer/step_book.hpp"
#include "experiment/metrics/observation.hpp"
#include "idl/world_types.hpp"
#include "runtime/bus/bus.hpp"
#include "runtime/process/loop.hpp"

namespace caravan::deploy {

/// The launcher's side of the bus: turns truth and telemetry into observations, without missing a step.
///
/// It gives the world credit, so the world never runs more than 256 steps ahead of it.
class Observer {
 public:
  /// Everything that arrived since the last look().
  struct News {
    std::vector<experiment::Observation> observations;  ///< whole steps, in order
    bool last_seen = false;  ///< the run is decided and its last observation was among them
    std::optional<caravan_interfaces::msg::WorldStatus> world;  ///< the latest
    std::uint64_t world_statuses = 0;                           ///< number of statuses received so far
    std::optional<caravan_interfaces::msg::RadioStatus> radio;
    double agents_compute_s = 0.0;
    std::vector<std::string> strangers;  ///< participants whose samples were refused, and by which process
  };

  /// @param name  name of this observer, used by the world
  /// @param loop  notified when enough has arrived for a look()
  Observer(const runtime::BusConfig& bus, const std::string& name, std::uint32_t robots, runtime::Loop& loop);
  ~Observer();
  Observer(const Observer&) = delete;
  Observer& operator=(const Observer&) = delete;

  /// Takes everything that has arrived.
  [[nodiscard]] News look();
  /// Tells the world that everything up to `stamp` is handled.
  void give_credit(experiment::Time stamp);

 private:
  [[nodiscard]] std::vector<std::string> strangers(const News& news) const;
  /// Wakes the loop when enough has arrived.
  void tell(bool is_last);

  runtime::Loop& loop_;
  std::string name_;
  std::mutex mutex_;
  StepBook book_;
  News news_;
  std::optional<std::chrono::nanoseconds> ended_;  // the last truth's time
  RunReaders readers_;
  runtime::Bus bus_;  // after the members that its callbacks use
  runtime::Writer<caravan_interfaces::msg::RunCreditPubSubType> credit_;
};

}  // namespace caravan::deploy
