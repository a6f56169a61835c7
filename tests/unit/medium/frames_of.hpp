// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "radio_emulator/medium/medium.hpp"

namespace caravan::radio {

/// The frames of a reception without their signal strength, so that they can be compared.
inline std::vector<Frame> frames_of(const Reception& reception) {
  std::vector<Frame> frames;
  for (const ReceivedFrame& frame : reception.frames) frames.push_back({frame.channel, frame.bytes});
  return frames;
}

}  // namespace caravan::radio
