// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <exception>
#include <optional>

#include "runtime/bus/fastdds_version.hpp"
#include "runtime/bus/strangers.hpp"

namespace caravan::runtime {

namespace detail {
/// Why the sample that this thread has read last is refused; none: it is good.
[[nodiscard]] std::optional<Refusal>& refusal_of_this_thread();
}  // namespace detail

/// No sample of ours is so long: a path of 65535 points has half of that.
inline constexpr std::uint32_t kMostBytes = 2U << 20U;

/// Generated type support that takes any bytes.
///
/// That of fastddsgen lets exceptions through (a boolean that is neither 0 nor 1, no memory), on a thread of
/// DDS, where they end the process. Here such a sample is empty, and refusal_of_this_thread() says why: DDS
/// is told that all went well, because what it does with a sample that failed differs between its versions.
/// Fast CDR compares the length of each sequence with the bytes that are left before it takes memory.
template <typename PubSubType>
class CheckedType final : public PortableType<PubSubType> {
 public:
  bool read(Payload& from, void* sample) override {
    auto& refusal = detail::refusal_of_this_thread();
    refusal.reset();
    if (from.length > kMostBytes) refusal = Refusal::kTooLong;
    try {
      if (!refusal && !PortableType<PubSubType>::read(from, sample)) refusal = Refusal::kMalformed;
    } catch (const std::exception&) {
      refusal = Refusal::kMalformed;
    }
    if (refusal) *static_cast<typename PubSubType::type*>(sample) = {};
    return true;
  }
};

}  // namespace caravan::runtime
