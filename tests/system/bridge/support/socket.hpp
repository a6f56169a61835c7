// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace caravan::test {

/// A TCP connection on 127.0.0.1; closed by its destructor.
class Socket {
 public:
  /// Connects. @return none if nothing listens there
  static std::optional<Socket> to(std::uint16_t port);
  explicit Socket(int descriptor) : descriptor_{descriptor} {}
  ~Socket();
  Socket(Socket&& other) noexcept;
  Socket& operator=(Socket&& other) noexcept;

  /// @return false if the other end is gone
  bool write(std::span<const std::uint8_t> bytes) const;
  /// The bytes that arrive within `patience`, possibly none. @return none if the other end is gone
  [[nodiscard]] std::optional<std::vector<std::uint8_t>> read(std::chrono::milliseconds patience) const;
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  int descriptor_ = -1;
};

}  // namespace caravan::test
