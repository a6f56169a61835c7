// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

/// Targets that a fuzzer calls with arbitrary bytes. Each aborts if its assertion does not hold.
namespace caravan::agent::fuzz {

/// Decoded messages are encoded to the same bytes.
void codec(std::span<const std::uint8_t> bytes);

/// A robot handles any frames in any order and never stands still longer than its bound. The bytes are a list
/// of steps: one byte for the number of frames, then for each frame a length byte and as many bytes.
void communication(std::span<const std::uint8_t> bytes);

}  // namespace caravan::agent::fuzz
