// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "radio_emulator/medium/link_rules.hpp"
#include "radio_emulator/medium/propagation.hpp"
#include "runtime/pure/robot_model.hpp"

namespace caravan::radio {

/// The medium's rules. TOML table `[radio]`.
struct MediumConfig {
  PropagationConfig propagation;
  std::uint32_t channel_count = robot_model::kChannelCount;  ///< channels are 0 .. channel_count - 1
  std::uint32_t mtu_bytes = robot_model::kMtu_bytes;         ///< longer frames are refused
  std::uint32_t queue_length = 64;  ///< frames that one receiver accepts in a step; further ones are dropped
  std::uint64_t seed = 1;           ///< same seed, same losses
};

/// A member of the step and its position, frame W, metres.
struct Station {
  std::uint32_t robot = 0;
  double x_m = 0.0;
  double y_m = 0.0;
};

struct Frame {
  std::uint32_t channel = 0;
  std::vector<std::uint8_t> bytes;
  bool operator==(const Frame&) const = default;
};

/// The transmission of one robot in a step. The emulator knows the sender; nothing in the bytes can change
/// that.
struct Transmission {
  std::uint32_t robot = 0;
  std::uint32_t tuned = 0;  ///< the channel it listens on
  std::vector<Frame> frames;
};

struct ReceivedFrame {
  std::uint32_t channel = 0;
  std::vector<std::uint8_t> bytes;
  double signal_strength_dbm = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not reported
};

/// The frames that one robot receives, sorted by sender, then in the order of sending.
struct Reception {
  std::uint32_t robot = 0;
  std::vector<ReceivedFrame> frames;
};

struct Drops {
  std::uint64_t over_mtu = 0;
  std::uint64_t bad_channel = 0;
  std::uint64_t lost = 0;  ///< by loss_probability or a rule
  std::uint64_t queue_full = 0;
};

/// The medium for one step. Pure: equal arguments, equal result.
///
/// A frame reaches every other station that is tuned to its channel in this step and that propagate() lets it
/// reach. Nothing else is modelled: no obstacle, collision or interference. Losses are drawn from (seed,
/// step, sender, receiver, index of the frame), so that an additional frame does not change the loss of any
/// other.
///
/// A frame over the MTU or on a channel that does not exist is refused and counted once, whatever is in
/// range.
///
/// @param step           unique number of the step: its stamp in nanoseconds in every engine
/// @param stations       the step's members, any order. Ignored: a transmission of a robot that is not among
///                       them, and a second station of the same robot. A station whose position is not finite
///                       is out of range of all others
/// @param transmissions  one for each robot, any order; of several the first counts; a station without one
///                       receives and sends nothing
/// @param drops          its counters are increased
/// @param rules          replace the loss of the links that they match
/// @return only robots that receive something, sorted by id
[[nodiscard]] std::vector<Reception> deliver(const MediumConfig& config, std::uint64_t step,
                                             std::span<const Station> stations,
                                             std::span<const Transmission> transmissions, Drops& drops,
                                             std::span<const LinkRule> rules = {});

}  // namespace caravan::radio
