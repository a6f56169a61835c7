// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "hardware_bridge/core/host/bridge.hpp"
#include "hardware_bridge/shell/line.hpp"
#include "idl/robot_types.hpp"
#include "runtime/bus/bus.hpp"
#include "runtime/process/loop.hpp"
#include "runtime/process/mailbox.hpp"

namespace caravan::bridge {

/// The devices of one robot.
struct Devices {
  PortAddress robot;
  std::optional<unsigned> baud;  ///< of the robot; none: it is searched
  std::optional<PortAddress> gps;
  unsigned gps_baud = 9600;
};

/// The bridge on the bus: rt/robot_<i>/sensors out, rt/robot_<i>/command in, a robot and a GPS receiver on
/// their ports.
///
/// The main thread owns everything; the bus's receiving thread only leaves commands in a mailbox. A device
/// that is gone is opened again every half second.
class PioneerShell {
 public:
  PioneerShell(const BridgeConfig& config, std::uint32_t robot, const Devices& devices,
               const runtime::BusConfig& bus, runtime::Loop& loop);
  ~PioneerShell();
  PioneerShell(const PioneerShell&) = delete;
  PioneerShell& operator=(const PioneerShell&) = delete;

  /// Until the loop is told to stop; then stops the wheels and closes the connection. @return the exit code
  int run();

 private:
  using Wall = runtime::WallTime;
  struct Mail {
    runtime::ParticipantId from;
    std::optional<caravan_interfaces::msg::RobotCommand> command;  ///< none: it is gone
  };

  [[nodiscard]] Time now() const { return std::chrono::steady_clock::now() - began_; }
  void read_mailbox();
  void keep_lines_open();
  void open_robot();
  void attend_robot(bool ready);
  void attend_gps(bool ready);
  void carry_out();
  void publish(const Frame& frame);
  void end();
  /// Says it once for each new reason.
  void say(std::string& said, const std::string& text);

  const Devices devices_;
  runtime::Loop& loop_;
  const Wall began_;
  const std::uint64_t session_;

  Bridge bridge_;
  Line robot_;
  Line gps_;
  bool robot_was_up_ = false;
  bool gps_was_open_ = false;
  std::size_t baud_ = 0;  // of the rates that are tried
  Time retry_robot_{0};
  Time retry_gps_{0};
  std::string said_robot_;
  std::string said_gps_;
  std::optional<runtime::ParticipantId> agent_;
  std::uint64_t refused_writes_ = 0;

  runtime::Mailbox<Mail> mailbox_{loop_};

  caravan_interfaces::msg::SensorFrame frame_;
  runtime::Bus bus_;  // after the state, so that no callback outlives it
  runtime::Writer<caravan_interfaces::msg::SensorFramePubSubType> sensors_;
};

}  // namespace caravan::bridge
