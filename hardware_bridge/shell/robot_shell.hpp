// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <set>

#include "hardware_bridge/core/robot/body_watch.hpp"
#include "hardware_bridge/core/robot/gps_receiver.hpp"
#include "hardware_bridge/core/robot/microcontroller.hpp"
#include "hardware_bridge/shell/line.hpp"
#include "hardware_bridge/shell/listener.hpp"
#include "hardware_bridge/shell/sole_server.hpp"
#include "idl/robot_types.hpp"
#include "runtime/bus/bus.hpp"
#include "runtime/bus/tenure.hpp"
#include "runtime/process/loop.hpp"
#include "runtime/process/mailbox.hpp"

namespace caravan::bridge {

/// An emulated Pioneer between a body in the world and a host on TCP.
///
/// The bus's receiving thread handles the body's frames and answers them. The main thread serves both ports
/// and the robot's timers. The robot is switched on with the first frame, and again with the first frame of a
/// new session: then the host's connection ends.
class RobotShell {
 public:
  struct Ports {
    std::uint16_t robot = 0;  ///< 0: chosen by the kernel
    std::uint16_t gps = 0;
  };
  RobotShell(const RobotConfig& config, std::uint32_t robot, const Ports& ports,
             const runtime::BusConfig& bus, runtime::Loop& loop);
  ~RobotShell();
  RobotShell(const RobotShell&) = delete;
  RobotShell& operator=(const RobotShell&) = delete;

  /// Runs until the loop stops. @return the exit code
  /// @throws StartError when another process emulates the robot
  int run();

 private:
  using Wall = runtime::WallTime;

  // Called with the lock held.
  /// @throws StartError as run() does
  void read_mailbox();
  void on_body(const caravan_interfaces::msg::SensorFrame& frame);
  void answer(const caravan_interfaces::msg::SensorFrame& frame);
  [[nodiscard]] Time now() const { return std::chrono::steady_clock::now() - began_; }
  [[nodiscard]] Wall next_deadline() const;
  void tell_whether_a_body_is_there();
  void tell_ignored_commands();
  void let_in_a_host();
  void let_go_of_a_silent_host();
  void let_go_of_a_host_that_has_gone();
  void let_in_a_gps_client();
  void attend_robot(bool host_waits, bool ready);
  void attend_gps(bool client_waits, bool ready);

  const RobotConfig config_;
  const std::uint32_t number_;
  const std::uint32_t domain_;
  runtime::Loop& loop_;
  const Wall began_;
  Listener robot_port_;
  Listener gps_port_;
  Line host_;
  bool has_host_ = false;  // also while its line has failed and is not handled yet
  Line gps_client_;
  std::string host_peer_;  // addresses of the clients
  std::string gps_peer_;
  bool told_turned_away_ = false;        // since the last accepted host
  bool told_gps_turned_away_ = false;    // since the last accepted client
  std::set<std::uint8_t> told_unknown_;  // commands of this host
  std::set<std::uint8_t> told_malformed_;

  mutable std::mutex mutex_;
  Microcontroller robot_;
  GpsReceiver gps_;
  BodyWatch body_watch_;
  std::uint64_t session_ = 0;
  bool rebooted_ = false;  // since the last check by the main thread
  std::uint64_t refused_writes_ = 0;
  runtime::Tenure world_;

  runtime::Mailbox<runtime::Discovery> mailbox_{loop_};

  runtime::Bus bus_;  // after the state, so that no callback outlives it
  runtime::Writer<caravan_interfaces::msg::RobotCommandPubSubType> commands_;
  SoleServer sole_;
};

}  // namespace caravan::bridge
