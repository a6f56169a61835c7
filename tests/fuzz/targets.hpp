// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

/// What the fuzzer calls with bytes of its own. Each aborts when its claim does not hold.
namespace caravan::agent::fuzz {

/// Whatever decodes encodes to the same bytes.
void codec(std::span<const std::uint8_t> bytes);

/// A robot survives any frames in any order, and never stands still beyond its bound. The bytes are a list of
/// steps: one byte says how many frames follow, each frame is a length byte and so many bytes.
void communication(std::span<const std::uint8_t> bytes);

}  // namespace caravan::agent::fuzz
