// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "runtime/bus/bus.hpp"
#include "runtime/bus/compatibility.hpp"
#include "runtime/bus/fastdds_version.hpp"

namespace caravan::runtime {

/// Turns Fast DDS's discovery callbacks into Discovery values, and knows which participants are present.
///
/// A writer or reader of one of the topics of idl/topics.hpp that does not match ours is not reported. If
/// this process reads or writes that topic, the mismatch is logged.
class DiscoveryListener final : public DiscoveryEvents {
 public:
  explicit DiscoveryListener(Bus::DiscoveryCallback discovered) : discovered_{std::move(discovered)} {}

  enum class End : std::uint8_t { kWriter, kReader };
  /// Registers an own writer or reader of a topic.
  void has(End end, const std::string& topic);

  /// None for a participant that is unknown or has left.
  [[nodiscard]] std::optional<Identity> identity_of(const ParticipantId& id) const;
  /// No callback is running or will run after this.
  void mute();

 private:
  void participant_found(const rtps::GUID_t& guid, const std::string& name,
                         const Properties& properties) override;
  void participant_gone(const rtps::GUID_t& guid) override;
  void writer_found(dds::DomainParticipant* own, const rtps::GUID_t& guid, const std::string& topic,
                    const EndpointQos& qos) override;
  void writer_gone(dds::DomainParticipant* own, const rtps::GUID_t& guid, const std::string& topic) override;
  void reader_found(dds::DomainParticipant* own, const rtps::GUID_t& guid, const std::string& topic,
                    const EndpointQos& qos) override;

  /// A writer or reader of another participant.
  struct Endpoint {
    End end;
    ParticipantId participant;
    std::string topic;
    EndpointQos qos;
  };
  void found(const Endpoint& endpoint);
  void gone(Discovery::Kind kind, const ParticipantId& participant, const std::string& topic);
  void report(const Discovery& discovery) const;

  mutable std::mutex mutex_;
  Bus::DiscoveryCallback discovered_;
  std::map<ParticipantId, Identity> known_;
  std::set<std::pair<End, std::string>> ours_;
  std::vector<std::pair<std::pair<End, std::string>, std::string>>
      untold_;  // mismatches found before has(), by our end
};

}  // namespace caravan::runtime
