// SPDX-License-Identifier: Apache-2.0
#include "tests/system/bridge/support/cable.hpp"

#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

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
  std::optional<Ends> ends;
  while (!ending_) {
    if (ends && state_ != State::kPulled) {
      carry(*ends);
      if (ends->bridge.descriptor() < 0) ends.reset();
      continue;
    }
    ends.reset();
    pollfd watched{listener_.descriptor(), POLLIN, 0};
    if (poll(&watched, 1, 20) <= 0) continue;
    Socket bridge{accept4(listener_.descriptor(), nullptr, nullptr, SOCK_CLOEXEC)};
    if (state_ == State::kPulled) continue;
    auto device = Socket::to(device_);
    if (device) ends = Ends{std::move(bridge), std::move(*device)};
  }
}

void Cable::carry(Ends& ends) {
  std::array<pollfd, 2> watched{
      {{ends.bridge.descriptor(), POLLIN, 0}, {ends.device.descriptor(), POLLIN, 0}}};
  if (poll(watched.data(), watched.size(), 20) <= 0) return;
  bool whole = true;
  if (watched[0].revents != 0) whole = pass(ends.bridge, ends.device, false);
  if (whole && watched[1].revents != 0) whole = pass(ends.device, ends.bridge, true);
  if (!whole) ends = Ends{Socket{-1}, Socket{-1}};
}

bool Cable::pass(const Socket& from, const Socket& to, bool to_bridge) const {
  auto bytes = from.read(0ms);
  if (!bytes) return false;
  static thread_local pure::Random random{1};
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
    case State::kWhole:
    case State::kPulled:
      break;
  }
  return to.write(*bytes);
}

}  // namespace caravan::test
