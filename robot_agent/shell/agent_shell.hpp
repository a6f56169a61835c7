// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <optional>
#include <vector>

#include "robotPubSubTypes.h"
#include "robot_agent/core/agent.hpp"
#include "robot_agent/shell/clash.hpp"
#include "runtime/bus/bus.hpp"
#include "runtime/process/loop.hpp"

namespace caravan::agent {

/// One agent on the bus. Its five topics are all it has: sensors and radio/rx in, command, radio/tx and
/// telemetry out.
///
/// It steps on each sensor frame, on the bus's receiving thread; when the frame says that radio is due it
/// waits for that first, one second at most. The main thread keeps that deadline, and settles a clash with
/// another agent of the same number.
class AgentShell {
 public:
  AgentShell(const Config& config, const runtime::BusConfig& bus, runtime::Loop& loop);
  ~AgentShell();
  AgentShell(const AgentShell&) = delete;
  AgentShell& operator=(const AgentShell&) = delete;

  /// Until the loop is told to stop; then leaves the robot with its wheels at zero. @return the exit code
  /// @throws StartError when another agent holds the robot
  int run();

 private:
  using Wall = std::chrono::steady_clock::time_point;

  void on_sensors(const caravan_interfaces::msg::SensorFrame& frame);
  void on_receive(const caravan_interfaces::msg::RadioReceive& sample);
  /// False: a sample of a session that is over. A newer session starts the agent anew.
  [[nodiscard]] bool follow_session(std::uint64_t session);
  void step(const caravan_interfaces::msg::SensorFrame& frame);
  void halt();
  void watch(Wall now);
  [[nodiscard]] Wall next_deadline(Wall now) const;

  const Config config_;
  runtime::Loop& loop_;
  const Wall began_;

  std::mutex mutex_;
  std::uint64_t session_ = 0;
  std::optional<Agent> agent_;  // of this session
  Time now_{-1};                // stamp of the last frame stepped on
  std::vector<Frame> heard_;
  Time heard_until_{-1};                                         // stamp of the newest RadioReceive
  std::optional<caravan_interfaces::msg::SensorFrame> waiting_;  // for its radio
  Wall waiting_until_{};
  std::optional<caravan_interfaces::msg::SensorFrame> held_;  // the newest that came in a clash
  bool said_waiting_ = false;
  std::uint64_t radio_timeouts_ = 0;
  std::uint64_t refused_writes_ = 0;
  bool told_refused_writes_ = false;
  std::chrono::nanoseconds compute_{0};
  std::optional<Clash> clash_;

  std::mutex mailbox_mutex_;
  std::vector<runtime::Discovery> mailbox_;

  runtime::Bus bus_;  // after the state, so that no callback outlives it
  runtime::Writer<caravan_interfaces::msg::RobotCommandPubSubType> commands_;
  runtime::Writer<caravan_interfaces::msg::RadioTransmitPubSubType> transmits_;
  runtime::Writer<caravan_interfaces::msg::TelemetryPubSubType> telemetry_;
};

}  // namespace caravan::agent
