// SPDX-License-Identifier: Apache-2.0
#include "tests/system/bridge/support/cable.hpp"

#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>

#include "runtime/pure/random.hpp"

namespace caravan::test {

using namespace std::chrono_literals;

Cable::Cable(std::uint16_t device)
    : device_{device}, listener_{socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)} {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* name = reinterpret_cast<sockaddr*>(&address);
  if (bind(listener_.descriptor(), name, size) == 0 && listen(listener_.descriptor(), 4) == 0 &&
      getsockname(listener_.descriptor(), name, &size) == 0) {
    port_ = ntohs(address.sin_port);
  }
  thread_ = std::thread{[this] { run(); }};
}

Cable::~Cable() {
  ending_ = true;
  thread_.join();
}

void Cable::run() {
  Ends ends;
  while (!ending_) {
    if (state_ == State::kPulled) ends = Ends{};
    if (ends.bridge.descriptor() >= 0) {
      carry(ends);
    } else {
      plug_in(ends);
    }
  }
}

void Cable::plug_in(Ends& ends) const {
  pollfd watched{listener_.descriptor(), POLLIN, 0};
  if (poll(&watched, 1, 20) <= 0) return;
  Socket bridge{accept4(listener_.descriptor(), nullptr, nullptr, SOCK_CLOEXEC)};
  if (state_ == State::kPulled) return;
  if (ends.device.descriptor() >= 0) {
    (void)ends.device.read(0ms);  // what the device sent meanwhile is lost
  } else if (auto device = Socket::to(device_)) {
    ends.device = std::move(*device);
  } else {
    return;
  }
  ends.bridge = std::move(bridge);
}

void Cable::carry(Ends& ends) const {
  std::array<pollfd, 2> watched{
      {{ends.bridge.descriptor(), POLLIN, 0}, {ends.device.descriptor(), POLLIN, 0}}};
  const int ready = poll(watched.data(), watched.size(), 20);
  if (ready == 0 && !waiting_.empty()) {
    std::vector<std::uint8_t> bytes;
    slow_down(bytes);
    if (!ends.bridge.write(bytes)) ends = Ends{};
  }
  if (ready <= 0) return;
  if (watched[1].revents != 0 && !pass(ends.device, ends.bridge, true)) {
    ends = Ends{};
  } else if (watched[0].revents != 0 && !pass(ends.bridge, ends.device, false)) {
    ends.bridge = Socket{-1};
    // As on a serial line: beyond a cut a device cannot tell that the other end is closed.
    const State state = state_;
    if (state != State::kFrozen && state != State::kGarbled) ends.device = Socket{-1};
  }
}

bool Cable::pass(const Socket& from, const Socket& to, bool to_bridge) const {
  auto bytes = from.read(0ms);
  if (!bytes) return false;
  static thread_local pure::Random random{1};
  if (to_bridge) {
    const std::lock_guard lock{mutex_};
    if (change_) *bytes = change_(*bytes);
  }
  switch (state_) {
    case State::kFrozen:
      return true;
    case State::kGarbled:
      for (std::uint8_t& byte : *bytes) byte = static_cast<std::uint8_t>(random.word());
      break;
    case State::kNoisy:
      if (!to_bridge) break;
      for (int i = 0; i < 40; ++i)
        bytes->insert(bytes->begin(), static_cast<std::uint8_t>(random.word() % 0xfa));
      break;
    case State::kOneWay:
      if (!to_bridge) bytes->clear();
      break;
    case State::kSlow:
      if (to_bridge) slow_down(*bytes);
      break;
    case State::kWhole:
    case State::kPulled:
      break;
  }
  return to.write(*bytes);
}

/// Appends `bytes` to the waiting ones, then sets it to those that the line can carry by now.
void Cable::slow_down(std::vector<std::uint8_t>& bytes) const {
  constexpr double kBytesPerSecond = 350.0;
  const auto now = std::chrono::steady_clock::now();
  if (carried_ == 0 && waiting_.empty()) slow_since_ = now;
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  const double room = kBytesPerSecond * std::chrono::duration<double>(now - slow_since_).count();
  const std::size_t count = std::min(waiting_.size(), static_cast<std::size_t>(room) - carried_);
  bytes.assign(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(count));
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(count));
  carried_ += count;
}

}  // namespace caravan::test
