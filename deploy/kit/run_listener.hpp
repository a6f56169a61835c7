// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <caravan/seen.hpp>
#include "deploy/control/requester.hpp"
#include "deploy/kit/tally.hpp"
#include "deploy/observer/listen.hpp"
#include "deploy/observer/step_book.hpp"
#include "idl/control_types.hpp"
#include "idl/robot_types.hpp"
#include "idl/world_types.hpp"
#include "runtime/bus/bus.hpp"

namespace caravan::deploy {

/// The kit on the bus: combines truth, telemetry and statuses into one value, and sends control requests.
///
/// It gives the world credit, so it misses no step. When the world waits for it (`--await kit`), the first
/// credit also lets the world begin.
class RunListener {
 public:
  static constexpr const char* kName = "kit";

  /// @param facts       facts of every session
  /// @param hold_start  gives no credit before go()
  RunListener(const runtime::BusConfig& bus, experiment::RunFacts facts, bool hold_start);
  ~RunListener();
  RunListener(const RunListener&) = delete;
  RunListener& operator=(const RunListener&) = delete;

  [[nodiscard]] Seen seen() const;
  /// Returns when something has arrived since the last call of `seen()`, after `patience` at the latest.
  void wait_for_news(std::chrono::milliseconds patience);
  /// The world's process has ended: discards its state.
  void forget_world();
  void forget_radio();
  void go();
  /// From now on also receives the robots' radio frames. Costs one more reader per robot.
  void overhear();
  /// Sends a request to the latest world. `patience` includes the wait for a world.
  [[nodiscard]] ControlAnswer ask(caravan_interfaces::msg::ControlRequest request,
                                  std::chrono::milliseconds patience);

 private:
  void on_truth(const caravan_interfaces::msg::WorldTruth& truth);
  void on_status(const caravan_interfaces::msg::WorldStatus& status);
  void on_radio(const caravan_interfaces::msg::RadioStatus& status);
  void on_telemetry(std::uint32_t robot, const caravan_interfaces::msg::Telemetry& telemetry);
  void on_transmit(std::uint32_t robot, const caravan_interfaces::msg::RadioTransmit& transmit);
  /// Adds the complete steps to the tally.
  void count();
  /// False: a sample of a session that is over. A newer session resets the view of the robots.
  [[nodiscard]] bool follow_session(std::uint64_t session);
  void note(const std::string& event);
  void give_credit(const builtin_interfaces::msg::Time& stamp);

  mutable std::mutex mutex_;
  mutable bool has_news_ = false;
  std::condition_variable news_;
  experiment::RunFacts facts_;
  Seen seen_;
  StepBook book_;
  std::shared_ptr<Tally> tally_;
  std::optional<caravan_interfaces::msg::WorldStatus> world_;  // the latest
  std::optional<caravan_interfaces::msg::RadioStatus> radio_;
  bool gives_credit_;
  bool overhears_ = false;
  std::uint64_t credited_step_ = 0;
  Requester requester_;
  RunReaders readers_;
  runtime::Bus bus_;  // after the state, so that no callback outlives it
  runtime::Writer<caravan_interfaces::msg::RunCreditPubSubType> credit_;
};

}  // namespace caravan::deploy
