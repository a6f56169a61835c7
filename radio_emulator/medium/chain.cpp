// SPDX-License-Identifier: Apache-2.0
#include "radio_emulator/medium/chain.hpp"

#include <algorithm>

namespace caravan::radio {
namespace {

template <typename AnyFrame>
void write(pure::CanonicalBytes& out, const std::vector<AnyFrame>& frames) {
  out.word(frames.size());
  for (const AnyFrame& frame : frames) {
    out.word(frame.channel);
    out.bytes(frame.bytes);
  }
}

}  // namespace

pure::CanonicalBytes chain_link(std::int64_t stamp_ns, std::span<const Transmission> transmissions,
                                std::span<const Reception> receptions) {
  std::vector<const Transmission*> sorted;
  sorted.reserve(transmissions.size());
  for (const Transmission& transmission : transmissions) sorted.push_back(&transmission);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Transmission* a, const Transmission* b) { return a->robot < b->robot; });

  pure::CanonicalBytes out;
  out.word(static_cast<std::uint64_t>(stamp_ns));
  out.word(sorted.size());
  for (const Transmission* transmission : sorted) {
    out.word(transmission->robot);
    out.word(transmission->tuned);
    write(out, transmission->frames);
  }
  out.word(receptions.size());
  for (const Reception& reception : receptions) {
    out.word(reception.robot);
    write(out, reception.frames);
  }
  return out;
}

}  // namespace caravan::radio
