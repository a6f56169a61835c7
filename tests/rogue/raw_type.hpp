// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "runtime/bus/fastdds_version.hpp"

namespace caravan::test {

using Bytes = std::vector<std::uint8_t>;
using runtime::Payload;

inline bool write_bytes(const Bytes& bytes, Payload& to) {
  if (to.max_size < bytes.size()) return false;
  std::copy(bytes.begin(), bytes.end(), to.data);
  to.length = static_cast<std::uint32_t>(bytes.size());
  return true;
}

/// Type support of a writer whose samples are bytes, under the name of a real type.
template <typename PubSubType>
class RawType final : public runtime::PortableType<PubSubType> {
 public:
  using type = Bytes;

  bool write(const void* sample, Payload& to) override {
    return write_bytes(*static_cast<const Bytes*>(sample), to);
  }
  std::uint32_t size_of(const void* sample) override {
    return static_cast<std::uint32_t>(static_cast<const Bytes*>(sample)->size());
  }
};

/// A sample as on the wire.
template <typename PubSubType>
[[nodiscard]] Bytes bytes_of(const typename PubSubType::type& sample) {
  runtime::PortableType<PubSubType> type;
  Payload payload{type.size_of(&sample)};
  type.write(&sample, payload);
  return {payload.data, payload.data + payload.length};
}

}  // namespace caravan::test
