// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "idl/robot_types.hpp"
#include "robot_agent/controller/controllers.hpp"
#include "runtime/bus/bus.hpp"
#include "runtime/controller/call_watch.hpp"

namespace caravan::agent {

/// One agent of the process: its inputs so far, and its three writers.
///
/// Steps on each sensor frame. If the frame announces a radio sample, it waits for the sample first, for
/// about one second at most. Not thread-safe: the shell calls it under its lock. With `may_answer` false
/// (another process holds the robot) it keeps the newest frame and sends nothing.
class HostedAgent {
 public:
  using Wall = std::chrono::steady_clock::time_point;

  /// @throws StartError when DDS refuses a writer
  /// @param calls  counts the calls of controllers
  HostedAgent(const Controllers& controllers, const Config& config, runtime::Bus& bus, runtime::Calls& calls);

  /// From now on its frames come from another participant, whose session may have any number.
  void meet_provider() { is_new_provider_ = true; }
  void sense(const caravan_interfaces::msg::SensorFrame& frame, bool may_answer);
  void hear(const caravan_interfaces::msg::RadioReceive& sample, bool may_answer);
  /// Answers the frame that it has kept, and a frame that has waited too long for the radio. @pre this
  /// process holds the robot
  void catch_up(Wall now);
  /// Sets the wheels to zero, if it has ever had a world.
  void halt();

  [[nodiscard]] std::uint32_t robot() const { return config_.id.value; }
  [[nodiscard]] bool has_world() const { return session_ != 0; }
  [[nodiscard]] std::uint64_t refused_writes() const { return refused_writes_; }
  /// The error that ended the controller or its trace; empty: none. The controller is not called again, and
  /// the wheels are at zero.
  [[nodiscard]] const std::string& fault() const { return fault_; }
  /// What of the controller is called at present, as "a step"; null: nothing. Thread-safe.
  [[nodiscard]] const char* called() const { return called_; }
  /// What is called at present, to follow "controller mine, robot 3": ", step 40 (1.248 s):" or ": its
  /// constructor". Thread-safe.
  [[nodiscard]] std::string call_in_words() const;

 private:
  /// False: a frame of an old session. A newer session starts the agent from its initial state.
  [[nodiscard]] bool follow_session(std::uint64_t session);
  void take_in(const caravan_interfaces::msg::RadioReceive& sample);
  void step(const caravan_interfaces::msg::SensorFrame& frame);
  void break_off(const std::string& fault);
  void answer(caravan::Outputs& outputs, const caravan_interfaces::msg::SensorFrame& frame);

  const Controllers& controllers_;
  const Config config_;
  std::uint64_t session_ = 0;
  bool is_new_provider_ = true;
  std::optional<runtime::GuardedController> controller_;  // of this session
  Time now_{-1};                                          // stamp of the last step's frame
  std::vector<caravan::ReceivedFrame> heard_;
  Time heard_until_{-1};                                         // stamp of the newest RadioReceive
  std::optional<caravan_interfaces::msg::RadioReceive> early_;   // of a session that has no sensor frame yet
  std::optional<caravan_interfaces::msg::SensorFrame> waiting_;  // waits for its radio sample
  Wall waiting_until_{};
  std::optional<caravan_interfaces::msg::SensorFrame> held_;  // newest frame, kept while no answer is allowed
  std::string fault_;
  runtime::Calls& calls_;
  std::atomic<const char*> called_ = nullptr;
  std::atomic<std::uint64_t> steps_ = 0;   // of this controller, begun
  std::atomic<Time> called_at_ = Time{0};  // of the last of them
  std::uint64_t radio_timeouts_ = 0;
  std::uint64_t refused_writes_ = 0;
  std::chrono::nanoseconds compute_{0};
  runtime::Writer<caravan_interfaces::msg::RobotCommandPubSubType> commands_;
  runtime::Writer<caravan_interfaces::msg::RadioTransmitPubSubType> transmits_;
  runtime::Writer<caravan_interfaces::msg::TelemetryPubSubType> telemetry_;
};

}  // namespace caravan::agent
