// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include "robot_agent/core/radio/frames/codec.hpp"
#include "robot_agent/core/radio/frames/text.hpp"
#include "runtime/pure/assert.hpp"
#include "runtime/pure/overload.hpp"
#include "tests/fuzz/targets.hpp"

namespace caravan::agent::fuzz {

void codec(std::span<const std::uint8_t> bytes) {
  std::visit(
      pure::Overload{[&](const auto& message) {
                       const std::vector<std::uint8_t> again = encode(message);
                       CARAVAN_ASSERT(std::equal(again.begin(), again.end(), bytes.begin(), bytes.end()));
                       CARAVAN_ASSERT(!to_text(message).empty());
                     },
                     [](DecodeError) {}},
      decode(bytes));
}

}  // namespace caravan::agent::fuzz
