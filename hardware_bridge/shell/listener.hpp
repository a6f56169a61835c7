// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hardware_bridge/shell/descriptor.hpp"
#include "runtime/process/loop.hpp"

namespace caravan::bridge {

/// A TCP port of this machine, reachable only on 127.0.0.1.
class Listener {
 public:
  /// @param port  0: chosen by the kernel
  /// @throws StartError when the port is not available
  explicit Listener(std::uint16_t port);

  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] runtime::Polled watched() const { return {descriptor_.number(), false, false}; }
  struct Accepted {
    Descriptor connection;
    std::string peer;  ///< "127.0.0.1:40312"
  };
  /// The next pending connection.
  [[nodiscard]] std::optional<Accepted> accept() const;

 private:
  Descriptor descriptor_;
  std::uint16_t port_ = 0;
};

}  // namespace caravan::bridge
