// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "hardware_bridge/core/modem/air_packet.hpp"
#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge::modem {

/// What a radio can do (docs/bring_your_robot.md has examples).
struct RadioLimits {
  std::uint32_t mtu_bytes = 32;
  std::uint32_t channel_count = 126;
  double bit_rate_bps = 250000.0;
  Time channel_change = std::chrono::microseconds{130};  ///< deaf and mute meanwhile
  std::size_t queue_length = 64;                         ///< frames that wait to be sent
};

/// Takes turns between sending and listening on one radio, which is on one channel at a time.
///
/// Frames go out in their order, each for as long as its bits take; the radio changes to a frame's channel
/// for it, and back to the tuned one when nothing is left to send. While it sends or changes it hears
/// nothing.
class HalfDuplex {
 public:
  struct Frame {
    std::uint32_t channel = 0;
    Bytes bytes;
  };
  explicit HalfDuplex(const RadioLimits& limits) : limits_{limits} {}

  /// Listens there from now on, when it has nothing to send. A channel that there is not is ignored and
  /// counted.
  void tune(std::uint32_t channel, Time now);
  /// Frames over the MTU, on a channel that there is not, or for which the queue has no room are dropped and
  /// counted.
  void send(Frame frame, Time now);
  /// The next frame that goes on air at or before `now`; to be called until it gives none.
  [[nodiscard]] std::optional<Frame> next(Time now);
  /// When next() may give one; none: nothing waits.
  [[nodiscard]] std::optional<Time> next_deadline() const;
  /// Does it hear a frame of this channel that ends now?
  [[nodiscard]] bool hears(std::uint32_t channel, Time now) const;

  [[nodiscard]] std::uint64_t over_mtu() const { return over_mtu_; }
  [[nodiscard]] std::uint64_t bad_channel() const { return bad_channel_; }
  [[nodiscard]] std::uint64_t queue_full() const { return queue_full_; }

 private:
  void change_to(std::uint32_t channel, Time now);
  void listen(Time now);
  [[nodiscard]] Time airtime(const Frame& frame) const;

  RadioLimits limits_;
  std::uint32_t tuned_ = 0;
  std::uint32_t channel_ = 0;  // the radio is on it, or changes to it
  Time busy_until_{0};         // sends, or changes
  std::deque<Frame> queue_;
  std::uint64_t over_mtu_ = 0;
  std::uint64_t bad_channel_ = 0;
  std::uint64_t queue_full_ = 0;
};

}  // namespace caravan::bridge::modem
