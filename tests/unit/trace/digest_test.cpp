// SPDX-License-Identifier: Apache-2.0
// The programs agree with docs/digest.md.
#include "runtime/pure/digest.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "radio_emulator/medium/chain.hpp"
#include "runtime/pure/canonical_bytes.hpp"
#include "runtime/pure/hash_chain.hpp"
#include "tests/support/documented_digest.hpp"
#include "tests/unit/world/worlds.hpp"
#include "world_server/world.hpp"

namespace caravan {
namespace {

namespace documented = test::documented;

std::string text_of(std::span<const std::uint8_t> bytes) { return {bytes.begin(), bytes.end()}; }

void write_poses(std::string& bytes, const world::World& world) {
  for (const world::Pose& pose : world.poses()) {
    documented::real(bytes, pose.x_m);
    documented::real(bytes, pose.y_m);
    documented::real(bytes, pose.yaw_rad);
  }
}

TEST(DocumentedDigest, HasTheBytesOfTheWorldsSteps) {
  world::World world{world::empty_world(10.0, 2)};
  std::string bytes;
  // Left, right, gripper closed; no command for robot 2 in the second step.
  const std::vector<std::vector<std::optional<world::Command>>> told = {
      {world::Command{0.25, -0.5, true}, world::Command{-0.0, 1.0, false}},
      {world::Command{1.5, 1.5, true}, std::nullopt},
      {world::Command{0.1, 0.2, false}, world::Command{0.3, 0.4, true}}};
  for (std::size_t step = 0; step < told.size(); ++step) {
    if (step == 1) {
      ASSERT_EQ(world.place(2, {3.0, -3.0, 1.0}), "");
      documented::word(bytes, 2);
      write_poses(bytes, world);
      EXPECT_EQ(world.chain(), documented::chain(bytes));
    }
    const std::size_t begin = step == 1 ? bytes.size() - 8 - 2 * 24 : bytes.size();
    world.advance(told[step]);
    documented::word(bytes, step + 1);
    for (const auto& command : told[step]) {
      documented::word(bytes, command ? 1 : 0);
      documented::real(bytes, command ? command->left_mps : 0.0);
      documented::real(bytes, command ? command->right_mps : 0.0);
      documented::word(bytes, command && command->gripper_closed ? 1 : 0);
    }
    write_poses(bytes, world);
    EXPECT_EQ(text_of(world.chain_link()), bytes.substr(begin));
    EXPECT_EQ(world.chain_link().size(), 8U + 56 * 2 + (step == 1 ? 8 + 24 * 2 : 0));
  }

  EXPECT_EQ(world.chain(), documented::chain(bytes));
}

TEST(DocumentedDigest, HasTheBytesOfTheRadiosSteps) {
  const std::vector<radio::Transmission> sent = {{2, 5, {{0, {0x03}}, {5, {}}}}, {1, 0, {{0, {0x01, 0xff}}}}};
  const std::vector<radio::Reception> heard = {{2, {{0, {0x01, 0xff}}}}};
  // Stamp 32 ms; two transmissions: robot 1 on channel 0 with one frame, robot 2 on channel 5 with two; one
  // reception.
  std::string bytes;
  for (const std::uint64_t word : {32000000U, 2U, 1U, 0U, 1U, 0U, 2U}) documented::word(bytes, word);
  bytes += "\x01\xff";
  for (const std::uint64_t word : {2U, 5U, 2U, 0U, 1U}) documented::word(bytes, word);
  bytes += "\x03";
  for (const std::uint64_t word : {5U, 0U, 1U, 2U, 1U, 0U, 2U}) documented::word(bytes, word);
  bytes += "\x01\xff";

  EXPECT_EQ(text_of(radio::chain_link(32000000, sent, heard).view()), bytes);
}

TEST(DocumentedDigest, HasOneZeroAndOneNan) {
  for (const double value :
       {0.0, -0.0, 1.0, -1.5, 5e-324, std::numeric_limits<double>::infinity(),
        std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::quiet_NaN(),
        std::numeric_limits<double>::signaling_NaN()}) {
    pure::CanonicalBytes ours;
    ours.real(value);
    std::string theirs;
    documented::real(theirs, value);
    EXPECT_EQ(text_of(ours.view()), theirs) << value;
  }
}

TEST(DocumentedDigest, JoinsTheChainsOfKnownBytes) {
  const std::string world = "a step of the world";
  const std::string radio = "a step of the radio";
  pure::HashChain worlds;
  pure::HashChain radios;
  worlds.link(std::vector<std::uint8_t>{world.begin(), world.end()});
  radios.link(std::vector<std::uint8_t>{radio.begin(), radio.end()});

  EXPECT_EQ(documented::chain("a"), 0xaf63dc4c8601ec8cULL) << "FNV-1a as its authors publish it";
  EXPECT_EQ(worlds.value(), documented::chain(world));
  EXPECT_EQ(pure::digest(worlds.value(), radios.value()),
            documented::digest(documented::chain(world), documented::chain(radio)));
}

}  // namespace
}  // namespace caravan
