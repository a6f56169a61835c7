// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

/// Targets that a fuzzer calls with arbitrary bytes. Each aborts if its assertion does not hold.
namespace caravan::bridge::fuzz {

/// Packets, commands and SIPs are encoded to the bytes they were decoded from, however the stream is split.
void arcos(std::span<const std::uint8_t> bytes);

/// Decoded sentences are within their bounds, and are decoded again after encoding.
void nmea(std::span<const std::uint8_t> bytes);

/// Bridge and robot handle any bytes on their lines and stay within their bounds. The bytes are a list of
/// steps: the upper five bits of the first byte are the number of bytes that follow, the lower three select
/// their receivers.
void bridge(std::span<const std::uint8_t> bytes);

}  // namespace caravan::bridge::fuzz
