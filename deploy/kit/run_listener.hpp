// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "deploy/control/requester.hpp"
#include "deploy/kit/seen.hpp"
#include "deploy/observer/listen.hpp"
#include "deploy/observer/step_book.hpp"
#include "idl/control_types.hpp"
#include "idl/robot_types.hpp"
#include "idl/world_types.hpp"
#include "runtime/bus/bus.hpp"

namespace caravan::deploy {

/// The kit on the bus: keeps what truth, telemetry and statuses say as one value, and asks for control.
///
/// It gives the world credit, so it misses no step. When the world awaits it (`--await kit`), the first
/// credit is also what lets the world begin.
class RunListener {
 public:
  static constexpr const char* kName = "kit";

  /// @param facts       of every session
  /// @param hold_start  gives no credit before go()
  RunListener(const runtime::BusConfig& bus, experiment::RunFacts facts, bool hold_start);
  ~RunListener();
  RunListener(const RunListener&) = delete;
  RunListener& operator=(const RunListener&) = delete;

  [[nodiscard]] Seen seen() const;
  /// Returns when something was heard since `seen()` was called last, after `patience` at the latest.
  void wait_for_news(std::chrono::milliseconds patience);
  /// The world's process has ended: what it said is over.
  void forget_world();
  void forget_radio();
  void go();
  /// From now on also hears what the robots send by radio. Costs every robot a reader more.
  void overhear();
  /// Asks the newest world. Waits for one to be heard within `patience`, too.
  [[nodiscard]] ControlAnswer ask(caravan_interfaces::msg::ControlRequest request,
                                  std::chrono::milliseconds patience);

 private:
  void on_truth(const caravan_interfaces::msg::WorldTruth& truth);
  void on_status(const caravan_interfaces::msg::WorldStatus& status);
  void on_radio(const caravan_interfaces::msg::RadioStatus& status);
  void on_telemetry(std::uint32_t robot, const caravan_interfaces::msg::Telemetry& telemetry);
  void on_transmit(std::uint32_t robot, const caravan_interfaces::msg::RadioTransmit& transmit);
  /// Adds to the tally what is whole by now.
  void count();
  /// False: a sample of a session that is over. A newer one begins a new view of the robots.
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
  std::optional<caravan_interfaces::msg::WorldStatus> world_;  // the newest
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
