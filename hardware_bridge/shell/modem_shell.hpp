// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "hardware_bridge/core/host/notice_limit.hpp"
#include "hardware_bridge/core/host/retry.hpp"
#include "hardware_bridge/core/modem/half_duplex.hpp"
#include "hardware_bridge/shell/claim.hpp"
#include "hardware_bridge/shell/line.hpp"
#include "hardware_bridge/shell/sole_server.hpp"
#include "hardware_bridge/shell/udp_air.hpp"
#include "idl/robot_types.hpp"
#include "runtime/bus/bus.hpp"
#include "runtime/bus/tenure.hpp"
#include "runtime/process/loop.hpp"
#include "runtime/process/mailbox.hpp"

namespace caravan::bridge {

/// Address of the modem: a serial port, or the UDP port that all modems of this machine share.
struct ModemAddress {
  std::optional<Endpoint> serial;
  unsigned baud = 115200;
  std::uint16_t udp_port = 0;
};

/// Connects a robot's radio topics to a real radio: rt/robot_<i>/radio/tx in, rt/robot_<i>/radio/rx out.
///
/// Received frames are published at once, with the session and stamp of the agent's latest transmission. The
/// main thread owns the state; the bus's receiving thread only puts transmissions into a mailbox.
class ModemShell {
 public:
  ModemShell(const modem::RadioLimits& limits, std::uint32_t robot, const ModemAddress& address,
             const runtime::BusConfig& bus, runtime::Loop& loop);
  ~ModemShell();
  ModemShell(const ModemShell&) = delete;
  ModemShell& operator=(const ModemShell&) = delete;

  /// Runs until the loop stops. @return the exit code
  /// @throws StartError when another modem serves the robot, or the port cannot be a serial line
  int run();

 private:
  struct Transmission {
    runtime::Sender from;
    caravan_interfaces::msg::RadioTransmit sample;
  };
  using Mail = std::variant<runtime::Discovery, Transmission>;
  [[nodiscard]] Time now() const { return std::chrono::steady_clock::now() - began_; }
  [[nodiscard]] std::optional<runtime::WallTime> next_deadline() const;
  void read_mailbox();
  void read(const runtime::Discovery& news);
  void read(const Transmission& transmission);
  void take(const caravan_interfaces::msg::RadioTransmit& sample);
  void keep_line_open();
  void transmit();
  void attend_serial(bool ready);
  void hear(const Bytes& bytes);
  void tell_drops();
  void tell_gone(const std::string& why);

  const ModemAddress address_;
  runtime::Loop& loop_;
  const runtime::WallTime began_;
  const std::uint32_t number_;  // the robot's number
  const std::uint32_t own_;     // this modem's number in packets
  modem::HalfDuplex radio_;
  std::optional<Claim> claim_;
  std::optional<UdpAir> air_;
  Line line_;
  bool was_open_ = false;
  modem::SlipReader slip_;
  Retry retry_;
  NoticeLimit limit_;
  std::uint64_t told_drops_ = 0;
  runtime::Tenure agent_;
  std::uint64_t session_ = 0;
  builtin_interfaces::msg::Time stamp_;

  runtime::Mailbox<Mail> mailbox_{loop_};

  runtime::Bus bus_;  // after the state, so that no callback outlives it
  runtime::Writer<caravan_interfaces::msg::RadioReceivePubSubType> receives_;
  SoleServer sole_;
};

}  // namespace caravan::bridge
