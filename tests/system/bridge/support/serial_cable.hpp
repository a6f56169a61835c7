// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <termios.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>

#include "tests/system/bridge/support/socket.hpp"

namespace caravan::test {

/// Why this machine has no pseudo-terminals to use as serial ports; empty if it has them.
[[nodiscard]] std::string no_terminals_because();

/// A serial line to an emulated robot: a pseudo-terminal that carries the robot's bytes. If the baud rate at
/// the other end differs from the robot's, bytes arrive corrupted in both directions.
class SerialCable {
 public:
  SerialCable(std::uint16_t robot, speed_t robots_rate);
  ~SerialCable();
  SerialCable(const SerialCable&) = delete;
  SerialCable& operator=(const SerialCable&) = delete;

  /// The port that a bridge opens.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  void run();
  [[nodiscard]] bool rates_agree() const;

  speed_t robots_rate_;
  int near_ = -1;  // our end of the terminal
  int held_ = -1;  // its other end, held open: the terminal outlives a bridge that closes it
  std::filesystem::path path_;
  std::optional<Socket> robot_;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace caravan::test
