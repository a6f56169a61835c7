// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "hardware_bridge/core/modem/air_packet.hpp"
#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge::modem {

/// Limits of a radio; docs/bring_your_robot.md has examples.
struct RadioLimits {
  std::uint32_t mtu_bytes = 32;
  std::uint32_t channel_count = 126;
  double bit_rate_bps = 250000.0;
  Time channel_change = std::chrono::microseconds{130};  ///< the radio neither sends nor receives meanwhile
  std::size_t queue_length = 64;                         ///< frames waiting to be sent
};

/// Alternates between sending and receiving on one radio, which is on one channel at a time.
///
/// Frames are sent in order; each occupies the radio for its airtime. The radio changes to the channel of
/// each frame, and back to the tuned channel when no frame is left. It receives nothing while it sends or
/// changes channel.
class HalfDuplex {
 public:
  struct Frame {
    std::uint32_t channel = 0;
    Bytes bytes;
  };
  explicit HalfDuplex(const RadioLimits& limits) : limits_{limits} {}

  /// Tunes the radio to a channel, for the time when it does not send. An invalid channel is ignored and
  /// counted.
  void tune(std::uint32_t channel, Time now);
  /// Queues a frame. Frames over the MTU, on an invalid channel, or without room in the queue are dropped and
  /// counted.
  void send(Frame frame, Time now);
  /// The next frame that is on the air at `now` or before; call until there is none.
  [[nodiscard]] std::optional<Frame> next(Time now);
  /// Time of the next frame from next(); none: the queue is empty.
  [[nodiscard]] std::optional<Time> next_deadline() const;
  /// Whether the radio receives a frame on this channel that ends now.
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
  std::uint32_t channel_ = 0;  // current channel, or the one it changes to
  Time busy_until_{0};         // while sending or changing channel
  std::deque<Frame> queue_;
  std::uint64_t over_mtu_ = 0;
  std::uint64_t bad_channel_ = 0;
  std::uint64_t queue_full_ = 0;
};

}  // namespace caravan::bridge::modem
