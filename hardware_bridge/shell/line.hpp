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

/// A stream of bytes to a device. It never blocks. A line that has failed stays closed until the next open().
class Line {
 public:
  ~Line() { close(); }
  Line() = default;
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  /// Starts to open the line. @param baud  of a serial port: raw, 8 data bits, no parity, 1 stop bit
  /// @return the error if that is impossible, otherwise empty
  [[nodiscard]] std::string open(const Endpoint& endpoint, unsigned baud);
  /// Takes over an established connection.
  void adopt(Descriptor descriptor);
  void close();

  [[nodiscard]] bool is_open() const { return descriptor_.is_open(); }
  /// True when the line is open and bytes can flow.
  [[nodiscard]] bool is_up() const { return is_open() && !connecting_; }
  /// True when the line ended because the device, or a host in front of it, closed the connection.
  [[nodiscard]] bool is_closed_by_other_end() const { return closed_; }
  /// Why it is useless to open the line again: another program uses the serial port, or it is not one. Empty:
  /// it is not.
  [[nodiscard]] const std::string& unfit() const { return unfit_; }
  /// For Loop::wait().
  [[nodiscard]] runtime::Polled watched() const;

  /// Call when a wait reports the line ready: completes the connection, writes pending bytes, reads available
  /// ones.
  /// @return the bytes received; empty also when the line failed, or has just come up
  [[nodiscard]] Bytes attend();
  /// Abandons a connection attempt at its deadline.
  void expire(runtime::WallTime now);
  /// Next deadline of expire().
  [[nodiscard]] std::optional<runtime::WallTime> next_deadline() const;
  /// Writes what can be written now, the rest in attend(). A line with more than 64 KiB pending fails.
  void write(const Bytes& bytes);
  /// Why the line failed; empty: it has not.
  [[nodiscard]] const std::string& failure() const { return failure_; }

 private:
  void finish_connecting();
  void flush();
  void fail(const std::string& why);

  Descriptor descriptor_;
  bool connecting_ = false;
  bool closed_ = false;
  runtime::WallTime give_up_;  // deadline of the connection attempt
  Bytes waiting_;
  std::string failure_;
  std::string unfit_;
};

}  // namespace caravan::bridge
