// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace caravan::test {

/// A TCP connection on 127.0.0.1, closed with its owner.
class Socket {
 public:
  /// Connects. @return nothing when nobody listens
  static std::optional<Socket> to(std::uint16_t port);
  explicit Socket(int descriptor) : descriptor_{descriptor} {}
  ~Socket();
  Socket(Socket&& other) noexcept;
  Socket& operator=(Socket&& other) noexcept;

  /// False: the other end is gone.
  bool write(std::span<const std::uint8_t> bytes) const;
  /// What arrives within `patience`; none: the other end is gone.
  [[nodiscard]] std::optional<std::vector<std::uint8_t>> read(std::chrono::milliseconds patience) const;
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  int descriptor_ = -1;
};

}  // namespace caravan::test
