// SPDX-License-Identifier: Apache-2.0
#include "radio_emulator/medium/chain.hpp"

#include <gtest/gtest.h>

#include "runtime/pure/hash_chain.hpp"

namespace caravan::radio {
namespace {

using Transmissions = std::vector<Transmission>;
using Receptions = std::vector<Reception>;

std::uint64_t chained(std::int64_t stamp_ns, const Transmissions& sent, const Receptions& heard) {
  pure::HashChain chain;
  chain.link(chain_link(stamp_ns, sent, heard).view());
  return chain.value();
}

const Transmission kOne{1, 0, {{0, {1, 2}}}};
const Transmission kTwo{2, 5, {{0, {3}}, {5, {}}}};
const Reception kHeard{2, {{0, {1, 2}}}};

TEST(MediumChain, DoesNotDependOnTheOrderInWhichTransmissionsArrived) {
  EXPECT_EQ(chained(32, {kOne, kTwo}, {kHeard}), chained(32, {kTwo, kOne}, {kHeard}));
}

TEST(MediumChain, ChangesWithEverythingThatHappenedInTheStep) {
  const std::uint64_t value = chained(32, {kOne, kTwo}, {kHeard});
  EXPECT_NE(value, chained(64, {kOne, kTwo}, {kHeard}));
  EXPECT_NE(value, chained(32, {kOne}, {kHeard}));
  EXPECT_NE(value, chained(32, {kOne, kTwo}, {}));
  Transmission changed = kTwo;
  changed.tuned = 6;
  EXPECT_NE(value, chained(32, {kOne, changed}, {kHeard}));
  changed = kTwo;
  changed.frames[1].channel = 6;
  EXPECT_NE(value, chained(32, {kOne, changed}, {kHeard}));
  Reception other = kHeard;
  other.frames[0].bytes[1] = 3;
  EXPECT_NE(value, chained(32, {kOne, kTwo}, {other}));
}

TEST(MediumChain, RemembersEarlierSteps) {
  pure::HashChain chain;
  chain.link(chain_link(32, Transmissions{kOne}, Receptions{}).view());
  chain.link(chain_link(64, Transmissions{kTwo}, Receptions{}).view());
  EXPECT_NE(chain.value(), chained(64, {kTwo}, {}));
}

}  // namespace
}  // namespace caravan::radio
