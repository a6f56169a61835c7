// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "build_paths.hpp"
#include "runtime/pure/random.hpp"
#include "tests/fuzz/bridge_targets.hpp"
#include "tests/fuzz/targets.hpp"

namespace caravan::agent::fuzz {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<Bytes> corpus(const std::string& name) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator{CARAVAN_SOURCE_DIR "/tests/fuzz/corpus/" + name}) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<Bytes> inputs;
  for (const auto& path : files) {
    std::ifstream file{path, std::ios::binary};
    inputs.emplace_back(std::istreambuf_iterator<char>{file}, std::istreambuf_iterator<char>{});
  }
  return inputs;
}

/// Changes, cuts or doubles a few bytes, as a fuzzer does.
Bytes mutated(Bytes bytes, pure::Random& random) {
  const auto below = [&random](std::size_t limit) {
    return static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(limit)));
  };
  for (std::size_t changes = 1 + below(4); changes > 0 && !bytes.empty(); --changes) {
    const std::size_t place = below(bytes.size());
    const double what = random.unit();
    if (what < 0.6) {
      bytes[place] = static_cast<std::uint8_t>(random.word());
    } else if (what < 0.7) {
      bytes.resize(place);
    } else if (what < 0.9) {
      bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(place),
                   static_cast<std::uint8_t>(random.word()));
    } else {
      const Bytes copy = bytes;
      bytes.insert(bytes.end(), copy.begin(), copy.end());
    }
  }
  return bytes;
}

void replay(const std::string& name, void (*target)(std::span<const std::uint8_t>), std::uint64_t seeds) {
  const std::vector<Bytes> inputs = corpus(name);
  ASSERT_FALSE(inputs.empty());
  for (const Bytes& input : inputs) target(input);
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    pure::Random random{seed};
    for (const Bytes& input : inputs) target(mutated(input, random));
  }
}

TEST(FuzzReplay, WhateverDecodesEncodesToTheSameBytes) { replay("codec", codec, 2000); }

TEST(FuzzReplay, ARobotSurvivesAnyFrames) { replay("communication", communication, 500); }

TEST(FuzzReplay, ArcosPacketsComeBackFromAnyBytes) { replay("arcos", bridge::fuzz::arcos, 2000); }

TEST(FuzzReplay, NmeaSentencesComeBackFromAnyBytes) { replay("nmea", bridge::fuzz::nmea, 2000); }

TEST(FuzzReplay, ABridgeSurvivesAnyBytesOnItsLines) { replay("bridge", bridge::fuzz::bridge, 200); }

}  // namespace
}  // namespace caravan::agent::fuzz
