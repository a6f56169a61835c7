// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "hardware_bridge/core/host/baud_search.hpp"
#include "hardware_bridge/core/host/bridge.hpp"
#include "hardware_bridge/core/host/notice_limit.hpp"
#include "hardware_bridge/core/host/retry.hpp"
#include "hardware_bridge/shell/claim.hpp"
#include "hardware_bridge/shell/line.hpp"
#include "hardware_bridge/shell/sole_server.hpp"
#include "idl/robot_types.hpp"
#include "runtime/bus/bus.hpp"
#include "runtime/bus/tenure.hpp"
#include "runtime/process/loop.hpp"
#include "runtime/process/mailbox.hpp"

namespace caravan::bridge {

/// The devices of one robot.
struct Devices {
  Endpoint robot;
  std::optional<unsigned> baud;  ///< of the robot; none: search for it
  std::optional<Endpoint> gps;
  unsigned gps_baud = 9600;
};

/// The Pioneer bridge on the bus: rt/robot_<i>/sensors out, rt/robot_<i>/command in, with a robot and a GPS
/// receiver on their ports.
///
/// The main thread owns the state; the bus's receiving thread only puts commands into a mailbox. A lost line
/// is reopened (see Retry). Repeated messages pass a NoticeLimit.
class PioneerShell {
 public:
  /// @throws StartError when another bridge uses a device
  PioneerShell(const BridgeConfig& config, std::uint32_t robot, const Devices& devices,
               const runtime::BusConfig& bus, runtime::Loop& loop);
  ~PioneerShell();
  PioneerShell(const PioneerShell&) = delete;
  PioneerShell& operator=(const PioneerShell&) = delete;

  /// Runs until the loop stops; then stops the wheels and closes the connection. @return the exit code
  /// @throws StartError when another bridge serves the robot, another program has a port, or the robot cannot
  /// be driven
  int run();

 private:
  using Wall = runtime::WallTime;
  struct Command {
    runtime::Sender from;
    caravan_interfaces::msg::RobotCommand sample;
  };
  using Mail = std::variant<runtime::Discovery, Command>;

  /// A device with its line, and the schedule of its reopening.
  struct Port {
    /// @throws StartError when another bridge uses the device
    Port(Endpoint device, const std::string& prefix, const std::string& option)
        : endpoint{std::move(device)},
          name{prefix + to_text(endpoint.address)},
          claim{canonical(endpoint), option} {}

    Endpoint endpoint;
    std::string name;  ///< for messages
    Claim claim;
    Line line;
    Retry retry;
    bool was_ours = false;  ///< has been open before
    bool opened = false;    ///< has been open, and its end is not reported yet
  };

  [[nodiscard]] Time now() const { return std::chrono::steady_clock::now() - began_; }
  [[nodiscard]] Wall next_deadline() const;
  void read_mailbox();
  void read(const runtime::Discovery& news);
  void read(const Command& command);
  void obey(const caravan_interfaces::msg::RobotCommand& command);
  void keep_lines_open();
  void open(Port& port, unsigned baud);
  /// @return the bytes received
  [[nodiscard]] Bytes attend(Port& port, bool ready);
  void attend_robot(bool ready);
  void attend_gps(bool ready);
  void carry_out();
  void publish(const Frame& frame);
  void end();
  /// Stops the wheels and ends the bridge. @throws StartError with the reason
  [[noreturn]] void refuse(const std::string& why);
  void tell(Notice notice);
  void warn(std::string text) { tell({Notice::Weight::kWarning, std::move(text)}); }

  const std::optional<unsigned> baud_;
  const unsigned gps_baud_;
  runtime::Loop& loop_;
  const Wall began_;
  const std::uint64_t session_;
  const std::uint32_t number_;  // the robot's number

  Bridge bridge_;
  Port robot_;
  std::optional<Port> gps_;
  NoticeLimit limit_;
  BaudSearch search_;
  bool robot_was_up_ = false;
  runtime::Tenure agent_;
  std::uint64_t refused_writes_ = 0;

  runtime::Mailbox<Mail> mailbox_{loop_};

  caravan_interfaces::msg::SensorFrame frame_;
  runtime::Bus bus_;  // after the state, so that no callback outlives it
  runtime::Writer<caravan_interfaces::msg::SensorFramePubSubType> sensors_;
  SoleServer sole_;
};

}  // namespace caravan::bridge
