// SPDX-License-Identifier: Apache-2.0
#include "radio_emulator/medium/chain.hpp"

#include <algorithm>

namespace caravan::radio {
namespace {

void feed(pure::HashChain& chain, const std::vector<Frame>& frames) {
  chain.word(frames.size());
  for (const Frame& frame : frames) {
    chain.word(frame.channel);
    chain.bytes(frame.bytes);
  }
}

}  // namespace

void chain_step(pure::HashChain& chain, std::int64_t stamp_ns, std::span<const Transmission> transmissions,
                std::span<const Reception> receptions) {
  std::vector<const Transmission*> sorted;
  sorted.reserve(transmissions.size());
  for (const Transmission& transmission : transmissions) sorted.push_back(&transmission);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Transmission* a, const Transmission* b) { return a->robot < b->robot; });

  chain.word(static_cast<std::uint64_t>(stamp_ns));
  chain.word(sorted.size());
  for (const Transmission* transmission : sorted) {
    chain.word(transmission->robot);
    chain.word(transmission->tuned);
    feed(chain, transmission->frames);
  }
  chain.word(receptions.size());
  for (const Reception& reception : receptions) {
    chain.word(reception.robot);
    feed(chain, reception.frames);
  }
}

}  // namespace caravan::radio
