// SPDX-License-Identifier: Apache-2.0
#include "tests/system/bridge/support/serial_cable.hpp"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace caravan::test {

using namespace std::chrono_literals;

std::string no_terminals_because() {
  const int near = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  const bool is_whole = near >= 0 && grantpt(near) == 0 && unlockpt(near) == 0 && ptsname(near) != nullptr;
  const int far = is_whole ? open(ptsname(near), O_RDWR | O_NOCTTY | O_CLOEXEC) : -1;
  std::string reason = far >= 0 ? "" : std::string{"is /dev/pts mounted? "} + std::strerror(errno);
  close(far);
  close(near);
  return reason;
}

SerialCable::SerialCable(std::uint16_t robot, speed_t robots_rate)
    : robots_rate_{robots_rate},
      near_{posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)},
      robot_{Socket::to(robot)} {
  grantpt(near_);
  unlockpt(near_);
  path_ = ptsname(near_);
  held_ = open(path_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  thread_ = std::thread{[this] { run(); }};
}

SerialCable::~SerialCable() {
  ending_ = true;
  thread_.join();
  close(held_);
  close(near_);
}

bool SerialCable::rates_agree() const {
  termios settings{};
  return tcgetattr(held_, &settings) == 0 && cfgetospeed(&settings) == robots_rate_;
}

void SerialCable::run() {
  const auto garbled = [this](std::uint8_t byte) {
    return rates_agree() ? byte : static_cast<std::uint8_t>(byte * 73U + 41U);
  };
  while (!ending_ && robot_) {
    std::array<pollfd, 2> watched{{{near_, POLLIN, 0}, {robot_->descriptor(), POLLIN, 0}}};
    if (poll(watched.data(), watched.size(), 20) <= 0) continue;
    if ((watched[0].revents & POLLIN) != 0) {
      std::vector<std::uint8_t> bytes(256);
      const ssize_t count = ::read(near_, bytes.data(), bytes.size());
      bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
      for (std::uint8_t& byte : bytes) byte = garbled(byte);
      robot_->write(bytes);
    }
    if (watched[1].revents != 0) {
      auto bytes = robot_->read(0ms);
      if (!bytes) return;
      for (std::uint8_t& byte : *bytes) byte = garbled(byte);
      (void)!::write(near_, bytes->data(), bytes->size());
    }
  }
}

}  // namespace caravan::test
