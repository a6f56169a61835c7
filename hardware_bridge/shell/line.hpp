// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hardware_bridge/shell/descriptor.hpp"
#include "hardware_bridge/shell/endpoint.hpp"
#include "runtime/process/loop.hpp"

namespace caravan::bridge {

using Bytes = std::vector<std::uint8_t>;

/// A stream of bytes to a device. Once it is gone it stays so; open another. It never blocks.
class Line {
 public:
  ~Line() { close(); }
  Line() = default;
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  /// Begins to open. @param baud  of a serial port, 8 data bits, no parity, 1 stop bit, raw
  /// @return what is wrong when it cannot even begin, otherwise empty
  [[nodiscard]] std::string open(const Endpoint& endpoint, unsigned baud);
  /// Takes over a connection that is there.
  void adopt(Descriptor descriptor);
  void close();

  [[nodiscard]] bool is_open() const { return descriptor_.is_open(); }
  /// Open, and bytes can flow.
  [[nodiscard]] bool is_up() const { return is_open() && !connecting_; }
  /// It is gone because the device or a host before it ended the connection, or never took it up.
  [[nodiscard]] bool is_closed_by_other_end() const { return closed_; }
  /// Why opening it again is in vain: another program has the serial port for itself, or it is none. Empty:
  /// it is not.
  [[nodiscard]] const std::string& unfit() const { return unfit_; }
  /// To be put into Loop::wait().
  [[nodiscard]] runtime::Polled watched() const;

  /// After a wait that said ready: goes on connecting, writes what has waited, reads what is there.
  /// @return what has arrived; empty too when the line is gone or came up only now
  [[nodiscard]] Bytes attend();
  /// Gives up a connection that is still being made when its time is over.
  void expire(runtime::WallTime now);
  /// When expire() has something to do.
  [[nodiscard]] std::optional<runtime::WallTime> next_deadline() const;
  /// Writes now what can be written, the rest when attend() is called. More than 64 KiB behind is a line that
  /// is gone.
  void write(const Bytes& bytes);
  /// Why it is gone; empty while it is not.
  [[nodiscard]] const std::string& failure() const { return failure_; }

 private:
  void finish_connecting();
  void flush();
  void fail(const std::string& why);

  Descriptor descriptor_;
  bool connecting_ = false;
  bool closed_ = false;
  runtime::WallTime give_up_;  // connecting
  Bytes waiting_;
  std::string failure_;
  std::string unfit_;
};

}  // namespace caravan::bridge
