// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <exception>
#include <optional>
#include <type_traits>

#include "runtime/bus/strangers.hpp"

namespace caravan::runtime {

namespace detail {
/// Why the sample that this thread has read last is refused; none: it is good.
[[nodiscard]] std::optional<Refusal>& refusal_of_this_thread();

/// How deserialize() is given its bytes: by pointer or by reference, as the version of Fast DDS has it.
template <typename Function>
struct PayloadOf;
template <typename Class, typename Payload>
struct PayloadOf<bool (Class::*)(Payload, void*)> {
  using type = Payload;
};
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
class CheckedType final : public PubSubType {
 public:
  using Payload = typename detail::PayloadOf<decltype(&PubSubType::deserialize)>::type;

  bool deserialize(Payload payload, void* data) override {
    auto& refusal = detail::refusal_of_this_thread();
    refusal.reset();
    if (length_of(payload) > kMostBytes) refusal = Refusal::kTooLong;
    try {
      if (!refusal && !PubSubType::deserialize(payload, data)) refusal = Refusal::kMalformed;
    } catch (const std::exception&) {
      refusal = Refusal::kMalformed;
    }
    if (refusal) *static_cast<typename PubSubType::type*>(data) = {};
    return true;
  }

 private:
  static std::uint32_t length_of(Payload payload) {
    if constexpr (std::is_pointer_v<Payload>) {
      return payload->length;
    } else {
      return payload.length;
    }
  }
};

}  // namespace caravan::runtime
