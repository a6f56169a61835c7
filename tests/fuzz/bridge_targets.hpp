// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

/// What the fuzzer calls with bytes of its own. Each aborts when its claim does not hold.
namespace caravan::bridge::fuzz {

/// Packets, commands and SIPs come back from their bytes, however the stream is cut.
void arcos(std::span<const std::uint8_t> bytes);

/// Sentences stay in their bounds and come back from their text.
void nmea(std::span<const std::uint8_t> bytes);

/// Bridge and robot survive any bytes on their lines and keep to their bounds. The bytes are a list of steps:
/// the upper five bits of the first say how many follow, the lower three who gets them.
void bridge(std::span<const std::uint8_t> bytes);

}  // namespace caravan::bridge::fuzz
