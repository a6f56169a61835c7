// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/discovery.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <charconv>
#include <fastdds/dds/domain/DomainParticipant.hpp>

#include "runtime/bus/guid.hpp"

namespace caravan::runtime {
namespace {

constexpr std::size_t kMostUntold = 64;

/// The process that other makes state (Cyclone DDS does), for a participant without a name of our form.
Identity stated_identity(const std::string& name, const Properties& properties) {
  Identity identity = to_identity(name);
  if (identity.started_ms != 0) return identity;
  for (const auto& [key, text] : properties) {
    const std::string value = printable(text);
    if (key == "__ProcessName" && identity.role.empty()) identity.role = value;
    if (key == "__Hostname") identity.host = value;
    if (key == "__Pid") std::from_chars(value.data(), value.data() + value.size(), identity.pid);
  }
  return identity;
}

/// The table's row for a topic's name; null: not one of ours.
const idl::Topic* row_of(const std::string& name) {
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto first = std::find_if(name.begin(), name.end(), digit);
  const auto last = std::find_if_not(first, name.end(), digit);
  const std::string pattern =
      first == name.end() ? name : std::string{name.begin(), first} + "<i>" + std::string{last, name.end()};
  const auto* const row = std::find_if(idl::kTopics.begin(), idl::kTopics.end(),
                                       [&](const idl::Topic& topic) { return topic.name == pattern; });
  return row == idl::kTopics.end() ? nullptr : row;
}

}  // namespace

void DiscoveryListener::participant_found(const rtps::GUID_t& guid, const std::string& name,
                                          const Properties& properties) {
  const ParticipantId id = to_id(guid.guidPrefix);
  const std::lock_guard lock{mutex_};
  known_[id] = stated_identity(name, properties);
  report({Discovery::Kind::kJoined, id, known_[id], ""});
}

void DiscoveryListener::participant_gone(const rtps::GUID_t& guid) {
  gone(Discovery::Kind::kGone, to_id(guid.guidPrefix), "");
}

void DiscoveryListener::writer_found(dds::DomainParticipant* own, const rtps::GUID_t& guid,
                                     const std::string& topic, const EndpointQos& qos) {
  if (guid.guidPrefix != own->guid().guidPrefix) found({End::kWriter, to_id(guid.guidPrefix), topic, qos});
}

void DiscoveryListener::writer_gone(dds::DomainParticipant* own, const rtps::GUID_t& guid,
                                    const std::string& topic) {
  if (guid.guidPrefix != own->guid().guidPrefix)
    gone(Discovery::Kind::kWriterGone, to_id(guid.guidPrefix), topic);
}

void DiscoveryListener::reader_found(dds::DomainParticipant* own, const rtps::GUID_t& guid,
                                     const std::string& topic, const EndpointQos& qos) {
  if (guid.guidPrefix != own->guid().guidPrefix) found({End::kReader, to_id(guid.guidPrefix), topic, qos});
}

void DiscoveryListener::found(const Endpoint& endpoint) {
  const bool writes = endpoint.end == End::kWriter;
  const std::lock_guard lock{mutex_};
  const auto known = known_.find(endpoint.participant);
  const Identity identity = known == known_.end() ? Identity{} : known->second;
  if (const idl::Topic* row = row_of(endpoint.topic)) {
    const EndpointQos ours = qos_of(*row);
    const std::string lack = writes ? writer_lacks(endpoint.qos, ours) : writer_lacks(ours, endpoint.qos);
    if (!lack.empty()) {
      const std::string text = "no match topic=" + endpoint.topic + ": the " +
                               (writes ? "writer" : "reader") + " of " +
                               to_text(endpoint.participant, identity) + " is ignored: " + lack;
      const std::pair our_end{writes ? End::kReader : End::kWriter, endpoint.topic};
      if (ours_.contains(our_end))
        spdlog::warn("{}", text);
      else if (untold_.size() < kMostUntold)
        untold_.emplace_back(our_end, text);
      return;
    }
  }
  report({writes ? Discovery::Kind::kWriterFound : Discovery::Kind::kReaderFound, endpoint.participant,
          identity, endpoint.topic});
}

void DiscoveryListener::gone(Discovery::Kind kind, const ParticipantId& participant,
                             const std::string& topic) {
  const std::lock_guard lock{mutex_};
  const auto known = known_.find(participant);
  report({kind, participant, known == known_.end() ? Identity{} : known->second, topic});
  if (kind == Discovery::Kind::kGone && known != known_.end()) known_.erase(known);
}

void DiscoveryListener::has(End end, const std::string& topic) {
  const std::lock_guard lock{mutex_};
  const std::pair our_end{end, topic};
  ours_.insert(our_end);
  for (const auto& [of, text] : untold_) {
    if (of == our_end) spdlog::warn("{}", text);
  }
  std::erase_if(untold_, [&](const auto& one) { return one.first == our_end; });
}

std::optional<Identity> DiscoveryListener::identity_of(const ParticipantId& id) const {
  const std::lock_guard lock{mutex_};
  const auto known = known_.find(id);
  return known == known_.end() ? std::nullopt : std::optional{known->second};
}

void DiscoveryListener::mute() {
  const std::lock_guard lock{mutex_};
  discovered_ = {};
}

void DiscoveryListener::report(const Discovery& discovery) const {
  if (discovered_) discovered_(discovery);
}

}  // namespace caravan::runtime
