// SPDX-License-Identifier: Apache-2.0
/// Code shared by fastdds_2.hpp and fastdds_3.hpp.
#pragma once

#include <algorithm>
#include <fastdds/dds/core/policy/QosPolicies.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <string>
#include <utility>
#include <vector>

#include "runtime/bus/compatibility.hpp"

namespace caravan::runtime {
namespace dds = eprosima::fastdds::dds;

/// Properties of a participant: name and value.
using Properties = std::vector<std::pair<std::string, std::string>>;

template <typename Found>
Properties properties_of(const Found& properties) {
  Properties pairs;
  for (const auto& one : properties) pairs.emplace_back(one.first(), one.second());
  return pairs;
}

inline bool is_in_partition(const dds::PartitionQosPolicy& partition) {
  const std::vector<std::string> names = partition.getNames();
  const auto is_default = [](const std::string& name) { return name.empty() || name == "*"; };
  return !names.empty() && std::none_of(names.begin(), names.end(), is_default);
}

inline bool has_xcdr1(const dds::DataRepresentationQosPolicy& representation) {
  const auto& all = representation.m_value;
  return all.empty() || std::find(all.begin(), all.end(), dds::XCDR_DATA_REPRESENTATION) != all.end();
}

/// Discovery events of other participants; called on DDS threads.
template <typename Guid>
class DiscoveryEventsOf : public dds::DomainParticipantListener {
 protected:
  virtual void participant_found(const Guid& guid, const std::string& name, const Properties& properties) = 0;
  virtual void participant_gone(const Guid& guid) = 0;
  virtual void writer_found(dds::DomainParticipant* own, const Guid& guid, const std::string& topic,
                            const EndpointQos& qos) = 0;
  virtual void writer_gone(dds::DomainParticipant* own, const Guid& guid, const std::string& topic) = 0;
  virtual void reader_found(dds::DomainParticipant* own, const Guid& guid, const std::string& topic,
                            const EndpointQos& qos) = 0;
};

}  // namespace caravan::runtime
