// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include "robot_agent/core/radio/communication.hpp"
#include "runtime/pure/assert.hpp"
#include "tests/fuzz/targets.hpp"

namespace caravan::agent::fuzz {
namespace {

using std::chrono::milliseconds;

/// Takes the next step's frames from the front of the bytes.
std::vector<ReceivedFrame> next_frames(std::span<const std::uint8_t>& bytes, Channel channel) {
  const auto byte = [&bytes] {
    const std::uint8_t value = bytes.empty() ? std::uint8_t{0} : bytes[0];
    if (!bytes.empty()) bytes = bytes.subspan(1);
    return value;
  };
  std::vector<ReceivedFrame> frames;
  for (int count = byte() % 8; count > 0; --count) {
    const std::size_t wanted = byte();
    const std::size_t length = std::min(wanted, bytes.size());
    const auto content = bytes.first(length);
    frames.push_back({.channel = channel, .bytes = {content.begin(), content.end()}});
    bytes = bytes.subspan(length);
  }
  return frames;
}

}  // namespace

void communication(std::span<const std::uint8_t> bytes) {
  CommunicationSettings config;
  config.id = RobotId{5};
  config.sharing.starts = Time{0};
  Communication robot{config};
  const Path path{{0.0, 0.0}, {1.0, 0.5}, {2.0, 0.0}};
  const Time bound =
      config.sharing.accept_period * config.sharing.accept_attempts + config.sharing.session_timer;
  Time now{0};
  Time drove{0};
  Channel tuned;
  bool stands = false;
  for (int silent = 0; silent < 100; silent += bytes.empty() ? 1 : 0) {
    now += milliseconds{32};
    const std::vector<ReceivedFrame> heard = next_frames(bytes, tuned);
    const AirOutputs out = robot.step({now, heard, path});
    tuned = out.tuned;
    stands = out.stand_still;
    if (!stands) drove = now;
    CARAVAN_ASSERT(now - drove <= bound + milliseconds{32});
    CARAVAN_ASSERT(!out.frames.empty());
    for (const Frame& frame : out.frames) CARAVAN_ASSERT(frame.bytes.size() <= config.air.mtu_bytes);
    if (out.received) CARAVAN_ASSERT(out.received->size() >= 2);
  }
  CARAVAN_ASSERT(!stands);  // every attempt ends after 3.2 s of silence
}

}  // namespace caravan::agent::fuzz
