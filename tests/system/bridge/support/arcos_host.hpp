// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "hardware_bridge/core/arcos/command.hpp"
#include "hardware_bridge/core/arcos/packet.hpp"
#include "hardware_bridge/core/arcos/sip.hpp"
#include "tests/support/patience.hpp"
#include "tests/system/bridge/support/socket.hpp"

namespace caravan::test {

/// A host over TCP: sends the given packets and collects those that it receives.
class Host {
  using Bytes = bridge::arcos::Bytes;
  using Order = bridge::arcos::Order;
  using Sip = bridge::arcos::Sip;

 public:
  explicit Host(std::uint16_t port) : socket_{Socket::to(port)} {}
  [[nodiscard]] bool is_connected() const { return socket_.has_value(); }
  void say(const Bytes& packet) {
    if (socket_ && !socket_->write(packet)) socket_.reset();
  }
  void listen(std::chrono::milliseconds patience) {
    if (!socket_) return;
    const auto bytes = socket_->read(patience);
    if (!bytes) return socket_.reset();
    for (Bytes& data : packets_.feed(*bytes)) heard_.push_back(std::move(data));
  }
  /// The next packet; none if it does not arrive within `kPatience`.
  [[nodiscard]] std::optional<Bytes> next() {
    (void)eventually(
        [&] {
          if (heard_.empty()) listen(std::chrono::milliseconds{50});
          return !heard_.empty() || !socket_;
        },
        kPatience);
    if (heard_.empty()) return std::nullopt;
    Bytes first = std::move(heard_.front());
    heard_.erase(heard_.begin());
    return first;
  }
  /// The next SIP for which `wanted(sip)` holds. Sends `meanwhile` after each packet that it reads.
  template <typename Wanted>
  [[nodiscard]] std::optional<Sip> sip(Wanted wanted,
                                       const Bytes& meanwhile = bridge::arcos::encode(Order::kPulse)) {
    std::optional<Sip> found;
    (void)eventually(
        [&] {
          const auto data = next();
          const auto sip = data ? bridge::arcos::decode_sip(*data) : std::nullopt;
          if (sip && wanted(*sip)) found = sip;
          say(meanwhile);
          return found || !socket_;
        },
        kPatience);
    return found;
  }
  void open() {
    for (const Order order : {Order::kPulse, Order::kOpen, Order::kClose}) {
      say(bridge::arcos::encode(order));
      (void)next();
    }
    say(bridge::arcos::encode(Order::kOpen));
    say(bridge::arcos::encode(Order::kEnable, 1));
    say(bridge::arcos::encode(Order::kSonar, 1));
    say(bridge::arcos::encode(Order::kSetAcceleration, 2000));
    say(bridge::arcos::encode(Order::kSetAcceleration, -2000));
  }
  void hang_up() { socket_.reset(); }

 private:
  std::optional<Socket> socket_;
  bridge::arcos::PacketFinder packets_;
  std::vector<Bytes> heard_;
};

}  // namespace caravan::test
