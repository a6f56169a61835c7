// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <netinet/in.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hardware_bridge/shell/descriptor.hpp"
#include "runtime/process/loop.hpp"

namespace caravan::bridge {

using Bytes = std::vector<std::uint8_t>;

/// Where a device is: a serial port, or the same bytes over TCP.
struct PortAddress {
  std::string path;  ///< of a serial port; empty: TCP
  std::string host;
  std::string port;
  bool operator==(const PortAddress&) const = default;
};
/// @param text  "/dev/ttyUSB0" or "tcp:HOST:PORT"
/// @throws StartError naming `option` when it is neither
[[nodiscard]] PortAddress parse_port(const std::string& text, const std::string& option);
[[nodiscard]] std::string to_text(const PortAddress& address);

/// A stream of bytes to a device. Once it is gone it stays so; open another.
///
/// It never blocks but for the first opening of a host by its name, which waits for the resolver (some
/// seconds): later ones of the same host take the address that was found then.
class Line {
 public:
  /// Begins to open. @param baud  of a serial port, 8 data bits, no parity, 1 stop bit, raw
  /// @return what is wrong when it cannot even begin, otherwise empty
  [[nodiscard]] std::string open(const PortAddress& address, unsigned baud);
  /// Takes over a connection that is there.
  void adopt(Descriptor descriptor);
  void close();

  [[nodiscard]] bool is_open() const { return descriptor_.is_open(); }
  /// Open, and bytes can flow.
  [[nodiscard]] bool is_up() const { return is_open() && !connecting_; }
  /// To be put into Loop::wait().
  [[nodiscard]] runtime::Watched watched() const;

  /// After a wait that said ready: goes on connecting, writes what has waited, reads what is there.
  /// @return what has arrived; empty too when the line is gone or came up only now
  [[nodiscard]] Bytes attend();
  /// Writes now what can be written, the rest when attend() is called. More than 64 KiB behind is a line that
  /// is gone.
  void write(const Bytes& bytes);
  /// Why it is gone; empty while it is not.
  [[nodiscard]] const std::string& failure() const { return failure_; }

 private:
  void finish_connecting();
  void flush();
  void fail(const std::string& why);

  PortAddress looked_up_;
  std::optional<sockaddr_in> found_;  // where looked_up_ is
  Descriptor descriptor_;
  bool connecting_ = false;
  Bytes waiting_;
  std::string failure_;
};

}  // namespace caravan::bridge
