// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/modem/half_duplex.hpp"

#include <algorithm>
#include <utility>

namespace caravan::bridge::modem {

void HalfDuplex::tune(std::uint32_t channel, Time now) {
  if (channel >= limits_.channel_count) {
    ++bad_channel_;
    return;
  }
  tuned_ = channel;
  listen(now);
}

void HalfDuplex::send(Frame frame, Time now) {
  if (frame.bytes.size() > limits_.mtu_bytes) {
    ++over_mtu_;
  } else if (frame.channel >= limits_.channel_count) {
    ++bad_channel_;
  } else if (queue_.size() >= limits_.queue_length) {
    ++queue_full_;
  } else {
    queue_.push_back(std::move(frame));
    change_to(queue_.front().channel, now);
  }
}

void HalfDuplex::change_to(std::uint32_t channel, Time now) {
  if (channel_ == channel) return;
  channel_ = channel;
  busy_until_ = std::max(busy_until_, now) + limits_.channel_change;
}

void HalfDuplex::listen(Time now) {
  if (queue_.empty()) change_to(tuned_, now);
}

Time HalfDuplex::airtime(const Frame& frame) const {
  constexpr double kOverheadBytes = 9.0;  // preamble, address, length and CRC of an nRF24
  return to_time(8.0 * (kOverheadBytes + static_cast<double>(frame.bytes.size())) / limits_.bit_rate_bps);
}

std::optional<HalfDuplex::Frame> HalfDuplex::next(Time now) {
  if (queue_.empty() || now < busy_until_) return std::nullopt;
  Frame frame = std::move(queue_.front());
  queue_.pop_front();
  const Time begins = std::max(busy_until_, now - std::chrono::milliseconds{1});  // tolerance for a late call
  busy_until_ = std::max(begins, Time{0}) + airtime(frame);
  if (queue_.empty()) {
    change_to(tuned_, busy_until_);
  } else {
    change_to(queue_.front().channel, busy_until_);
  }
  return frame;
}

std::optional<Time> HalfDuplex::next_deadline() const {
  return queue_.empty() ? std::nullopt : std::optional{busy_until_};
}

bool HalfDuplex::hears(std::uint32_t channel, Time now) const {
  return now >= busy_until_ && queue_.empty() && channel == channel_;
}

}  // namespace caravan::bridge::modem
