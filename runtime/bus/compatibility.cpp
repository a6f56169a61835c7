// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/compatibility.hpp"

#include <array>
#include <cstddef>

namespace caravan::runtime {
namespace {

const char* to_text(EndpointQos::Durability durability) {
  constexpr std::array kWords{"VOLATILE", "TRANSIENT_LOCAL", "TRANSIENT", "PERSISTENT"};
  const auto index = static_cast<std::size_t>(durability);
  return index < kWords.size() ? kWords.at(index) : "of unknown kind";
}

}  // namespace

EndpointQos qos_of(const idl::Topic& topic) {
  EndpointQos qos;
  qos.type = topic.type;
  qos.reliable = topic.delivery != idl::Delivery::kLatest;
  const bool fleeting = !qos.reliable || topic.delivery == idl::Delivery::kRequest;
  qos.durability = fleeting ? EndpointQos::Durability::kVolatile : EndpointQos::Durability::kTransientLocal;
  return qos;
}

std::string writer_lacks(const EndpointQos& writer, const EndpointQos& reader) {
  std::string text;
  const auto lacks = [&text](const std::string& has, const std::string& needed) {
    text += (text.empty() ? "" : "; ") + std::string{"the writer's "} + has + ", the reader needs " + needed;
  };
  if (writer.type != reader.type) lacks("type is " + writer.type, reader.type);
  if (!writer.reliable && reader.reliable) lacks("reliability is BEST_EFFORT", "RELIABLE");
  if (writer.durability < reader.durability)
    lacks(std::string{"durability is "} + to_text(writer.durability), to_text(reader.durability));
  if (writer.xcdr1 != reader.xcdr1)
    lacks(writer.xcdr1 ? "data representation is XCDR1" : "data representation is XCDR2 only",
          reader.xcdr1 ? "XCDR1" : "XCDR2");
  if (writer.exclusive != reader.exclusive)
    lacks(writer.exclusive ? "ownership is EXCLUSIVE" : "ownership is SHARED",
          reader.exclusive ? "EXCLUSIVE" : "SHARED");
  if (writer.in_partition != reader.in_partition)
    lacks(writer.in_partition ? "publisher is in a partition" : "publisher is in no partition",
          reader.in_partition ? "that of its subscriber" : "none");
  return text;
}

}  // namespace caravan::runtime
