// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include "hardware_bridge/core/arcos/command.hpp"
#include "hardware_bridge/core/arcos/settings.hpp"
#include "hardware_bridge/core/arcos/sip.hpp"
#include "runtime/pure/assert.hpp"
#include "tests/fuzz/bridge_targets.hpp"

namespace caravan::bridge::fuzz {
namespace {

/// Decoded data is encoded to the same bytes, except for fields beyond those known.
void round_trips(const arcos::Bytes& data) {
  if (const auto sip = arcos::decode_sip(data); sip && sip->sonars.size() <= 32) {
    const arcos::Bytes again = arcos::encode(*sip);
    CARAVAN_ASSERT(again.size() <= data.size());
    CARAVAN_ASSERT(std::equal(again.begin(), again.end(), data.begin()));
  }
  if (const auto command = arcos::decode_command(data)) {
    arcos::PacketFinder finder;
    const auto found = finder.feed(arcos::encode(*command));
    CARAVAN_ASSERT(found.size() == 1 && arcos::decode_command(found[0]) == command);
  }
  if (const auto settings = arcos::decode_settings(data)) {
    const arcos::Bytes again = arcos::encode(*settings);
    CARAVAN_ASSERT(again.size() <= data.size() && std::equal(again.begin(), again.end(), data.begin()));
  }
  if (const auto names = arcos::decode_names(data)) {
    CARAVAN_ASSERT(arcos::decode_names(arcos::encode(*names)) == names);
  }
}

}  // namespace

void arcos(std::span<const std::uint8_t> bytes) {
  arcos::PacketFinder whole;
  const std::vector<arcos::Bytes> found = whole.feed(bytes);
  for (const arcos::Bytes& data : found) {
    CARAVAN_ASSERT(!data.empty() && data.size() <= arcos::kMostData);
    round_trips(data);
  }
  arcos::PacketFinder in_pieces;
  std::vector<arcos::Bytes> again;
  for (const std::uint8_t byte : bytes) {
    for (arcos::Bytes& data : in_pieces.feed({&byte, 1})) again.push_back(std::move(data));
  }
  CARAVAN_ASSERT(found == again);
  if (!bytes.empty() && bytes.size() <= arcos::kMostData) {
    round_trips({bytes.begin(), bytes.end()});
    arcos::PacketFinder finder;
    const auto framed = finder.feed(arcos::to_packet(bytes));
    CARAVAN_ASSERT(framed.size() == 1 &&
                   std::equal(bytes.begin(), bytes.end(), framed[0].begin(), framed[0].end()));
  }
}

}  // namespace caravan::bridge::fuzz
