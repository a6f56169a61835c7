// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <exception>
#include <optional>

#include "runtime/bus/fastdds_version.hpp"
#include "runtime/bus/strangers.hpp"

namespace caravan::runtime {

namespace detail {
/// Why the last sample read on this thread is refused; none: it is valid.
[[nodiscard]] std::optional<Refusal>& refusal_of_this_thread();
}  // namespace detail

/// None of our samples is that long: a path of 65535 points has half of it.
inline constexpr std::uint32_t kMostBytes = 2U << 20U;

/// Generated type support that accepts any bytes.
///
/// That of fastddsgen lets exceptions through (a boolean that is neither 0 nor 1, no memory), on a thread of
/// DDS, where they end the process. Here such a sample is empty, and refusal_of_this_thread() gives the
/// reason. DDS gets a success, because its reaction to a failed sample differs between its versions. Fast CDR
/// compares the length of each sequence with the remaining bytes before it allocates memory.
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
