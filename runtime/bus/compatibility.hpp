// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "idl/topics.hpp"

namespace caravan::runtime {

/// The properties that decide whether a writer and a reader of one topic match.
struct EndpointQos {
  enum class Durability : std::uint8_t { kVolatile, kTransientLocal, kTransient, kPersistent };
  std::string type;
  bool reliable = true;
  Durability durability = Durability::kTransientLocal;
  bool xcdr1 = true;          ///< plain CDR is offered (writer) or accepted (reader)
  bool exclusive = false;     ///< ownership
  bool in_partition = false;  ///< in any partition
};

/// Properties of our own writers and readers of a topic.
[[nodiscard]] EndpointQos qos_of(const idl::Topic& topic);

/// What the writer lacks for the reader, as text; empty: they match.
[[nodiscard]] std::string writer_lacks(const EndpointQos& writer, const EndpointQos& reader);

}  // namespace caravan::runtime
