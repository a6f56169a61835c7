// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include "runtime/bus/fastdds_version.hpp"

namespace caravan::test {

using Bytes = std::vector<std::uint8_t>;
using Payload = runtime::rtps::SerializedPayload_t;

inline bool write_bytes(const Bytes& bytes, Payload& payload) {
  if (payload.max_size < bytes.size()) return false;
  std::copy(bytes.begin(), bytes.end(), payload.data);
  payload.length = static_cast<std::uint32_t>(bytes.size());
  return true;
}

#if __has_include(<fastdds/config.hpp>)  // Fast DDS 3.1

using Representation = runtime::dds::DataRepresentationId_t;
inline constexpr Representation kPlain = runtime::dds::XCDR_DATA_REPRESENTATION;

/// Type support whose samples are bytes, under the name of a real type.
template <typename PubSubType>
class RawType : public PubSubType {
 public:
  using type = Bytes;

  bool serialize(const void* const data, Payload& payload, Representation /*which*/) override {
    return write_bytes(*static_cast<const Bytes*>(data), payload);
  }
  bool deserialize(Payload& payload, void* data) override {
    static_cast<Bytes*>(data)->assign(payload.data, payload.data + payload.length);
    return true;
  }
  std::uint32_t calculate_serialized_size(const void* const data, Representation /*which*/) override {
    return static_cast<std::uint32_t>(static_cast<const Bytes*>(data)->size());
  }
  void* create_data() override { return new Bytes; }
  void delete_data(void* data) override { delete static_cast<Bytes*>(data); }
};

/// A sample as it is on the wire.
template <typename PubSubType>
[[nodiscard]] Bytes bytes_of(const typename PubSubType::type& sample) {
  PubSubType type;
  Payload payload{type.calculate_serialized_size(&sample, kPlain)};
  type.serialize(&sample, payload, kPlain);
  return {payload.data, payload.data + payload.length};
}

template <typename Type>
bool read_bytes(Type& type, Payload& payload, void* sample) {
  return type.deserialize(payload, sample);
}

#else  // 2.9

/// Type support whose samples are bytes, under the name of a real type.
template <typename PubSubType>
class RawType : public PubSubType {
 public:
  using type = Bytes;

  bool serialize(void* data, Payload* payload) override {
    return write_bytes(*static_cast<const Bytes*>(data), *payload);
  }
  bool deserialize(Payload* payload, void* data) override {
    static_cast<Bytes*>(data)->assign(payload->data, payload->data + payload->length);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] { return static_cast<std::uint32_t>(static_cast<const Bytes*>(data)->size()); };
  }
  void* createData() override { return new Bytes; }
  void deleteData(void* data) override { delete static_cast<Bytes*>(data); }
};

/// A sample as it is on the wire.
template <typename PubSubType>
[[nodiscard]] Bytes bytes_of(typename PubSubType::type sample) {
  PubSubType type;
  Payload payload{type.getSerializedSizeProvider(&sample)()};
  type.serialize(&sample, &payload);
  return {payload.data, payload.data + payload.length};
}

template <typename Type>
bool read_bytes(Type& type, Payload& payload, void* sample) {
  return type.deserialize(&payload, sample);
}

#endif

}  // namespace caravan::test
