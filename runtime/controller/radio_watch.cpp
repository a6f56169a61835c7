// SPDX-License-Identifier: Apache-2.0
#include "runtime/controller/radio_watch.hpp"

namespace caravan::runtime {

void RadioWatch::say(Kind kind, const std::string& text, std::vector<std::string>& all) {
  if (said_->insert(kind).second) all.push_back(text + "; this is said once");
}

std::vector<std::string> RadioWatch::look(const Outputs& outputs) {
  std::vector<std::string> all;
  const auto channels = [this] {
    return "the channels are 0 to " + std::to_string(limits_.channel_count - 1);
  };
  for (const Frame& frame : outputs.frames) {
    if (frame.bytes.size() > limits_.mtu_bytes) {
      say(Kind::kLongFrame,
          "the radio drops a frame of " + std::to_string(frame.bytes.size()) + " bytes: radio.mtu_bytes is " +
              std::to_string(limits_.mtu_bytes),
          all);
    } else if (frame.channel >= limits_.channel_count) {
      say(Kind::kChannelOfFrame,
          "the radio drops a frame on channel " + std::to_string(frame.channel) + ": " + channels(), all);
    }
  }
  if (outputs.tuned_channel >= limits_.channel_count) {
    say(Kind::kTunedChannel,
        "nothing is heard on channel " + std::to_string(outputs.tuned_channel) +
            ", which it tunes to: " + channels(),
        all);
  }
  return all;
}

}  // namespace caravan::runtime
