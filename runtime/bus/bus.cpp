// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/bus.hpp"

#include <sched.h>

#include <algorithm>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "runtime/bus/fastdds_version.hpp"
#include "runtime/bus/place.hpp"
#include "runtime/bus/profile.hpp"
#include "runtime/bus/qos.hpp"
#include "runtime/bus/quiet_start.hpp"
#include "runtime/bus/shared_memory_port.hpp"
#include "runtime/bus/start_deadline.hpp"
#include "runtime/config/start_error.hpp"

namespace caravan::runtime {
namespace {

ParticipantId to_id(const rtps::GuidPrefix_t& prefix) {
  ParticipantId id;
  std::copy(std::begin(prefix.value), std::end(prefix.value), id.prefix.begin());
  return id;
}

/// Process-wide settings that must stand before the first participant.
void prepare_process() {
  // Batch scheduling: a sample that arrives does not preempt the sender, which saves half of the context
  // switches.
  const sched_param batch{};
  (void)sched_setscheduler(0, SCHED_BATCH, &batch);  // refused in some containers: slower, not wrong
  // With intraprocess delivery write() would call the reader's callback in the writer's thread, under the
  // writer's locks.
  turn_intraprocess_delivery_off();
  dds::DomainParticipantFactoryQos by_hand;
  by_hand.entity_factory().autoenable_created_entities = false;
  dds::DomainParticipantFactory::get_instance()->set_qos(by_hand);
}

/// A participant that has joined the domain; null when DDS refuses.
dds::DomainParticipant* join(const BusConfig& config, dds::DomainParticipantQos qos, const Place* place,
                             dds::DomainParticipantListener* listener) {
  const StartDeadline deadline{config.domain};
  auto* const factory = dds::DomainParticipantFactory::get_instance();
  const SendGate gate = hold_back_network(qos);
  auto* const participant =
      factory->create_participant(config.domain, qos, listener, dds::StatusMask::none());
  if (participant == nullptr) return nullptr;
  if (place != nullptr) {
    auto& wire = qos.wire_protocol();
    const auto own = participant->guid();
    wire.default_unicast_locator_list.push_back(shared_memory_locator(fresh_port(config.domain), own));
    place->settle(wire.builtin, own);
    participant->set_qos(qos);
  }
  const bool is_enabled = is_ok(participant->enable());
  *gate = true;
  if (is_enabled) return participant;
  factory->delete_participant(participant);
  return nullptr;
}

/// Turns Fast DDS's discovery callbacks into Discovery values.
class DiscoveryListener final : public DiscoveryEvents {
 public:
  explicit DiscoveryListener(Bus::DiscoveryCallback discovered) : discovered_{std::move(discovered)} {}

  /// No callback is running or will run after this.
  void mute() {
    const std::lock_guard lock{mutex_};
    discovered_ = {};
  }

 private:
  void participant_found(const rtps::GUID_t& guid, const std::string& name) override {
    const ParticipantId id = to_id(guid.guidPrefix);
    const std::lock_guard lock{mutex_};
    known_[id] = to_identity(name);
    report({Discovery::Kind::kJoined, id, known_[id], ""});
  }
  void participant_gone(const rtps::GUID_t& guid) override {
    const ParticipantId id = to_id(guid.guidPrefix);
    const std::lock_guard lock{mutex_};
    report({Discovery::Kind::kGone, id, known_[id], ""});
    known_.erase(id);
  }
  void writer_found(dds::DomainParticipant* own, const rtps::GUID_t& guid,
                    const std::string& topic) override {
    endpoint_found(Discovery::Kind::kWriterFound, own, guid, topic);
  }
  void reader_found(dds::DomainParticipant* own, const rtps::GUID_t& guid,
                    const std::string& topic) override {
    endpoint_found(Discovery::Kind::kReaderFound, own, guid, topic);
  }
  void endpoint_found(Discovery::Kind kind, const dds::DomainParticipant* own, const rtps::GUID_t& guid,
                      const std::string& topic) {
    if (guid.guidPrefix == own->guid().guidPrefix) return;
    const ParticipantId id = to_id(guid.guidPrefix);
    const std::lock_guard lock{mutex_};
    const auto known = known_.find(id);
    report({kind, id, known == known_.end() ? Identity{} : known->second, topic});
  }
  void report(const Discovery& discovery) {
    if (discovered_) discovered_(discovery);
  }

  std::mutex mutex_;
  Bus::DiscoveryCallback discovered_;
  std::map<ParticipantId, Identity> known_;
};

}  // namespace

class Bus::Inbox final : public dds::DataReaderListener {
 public:
  Inbox(std::shared_ptr<void> sample, Take take) : sample_{std::move(sample)}, take_{std::move(take)} {}

  void on_data_available(dds::DataReader* reader) override {
    dds::SampleInfo info;
    while (is_ok(reader->take_next_sample(sample_.get(), &info))) {
      if (info.valid_data) take_(sample_.get(), to_id(info.sample_identity.writer_guid().guidPrefix));
    }
  }

 private:
  std::shared_ptr<void> sample_;  // reused, so that a step allocates nothing
  Take take_;
};

struct Bus::Impl {
  Identity identity;
  ParticipantId id;
  DiscoveryListener listener;
  std::optional<Place> place;
  dds::DomainParticipant* participant = nullptr;
  dds::Publisher* publisher = nullptr;
  dds::Subscriber* subscriber = nullptr;
  std::vector<std::unique_ptr<Inbox>> inboxes;
  std::vector<dds::DataReader*> readers;
  std::map<std::string, dds::Topic*> topics;

  explicit Impl(DiscoveryCallback discovered) : listener{std::move(discovered)} {}

  dds::Topic* topic(const std::string& name, dds::TopicDataType* raw_type) {
    dds::TypeSupport type{raw_type};
    if (const auto made = topics.find(name); made != topics.end()) return made->second;
    const dds::TypeSupport known = participant->find_type(type.get_type_name());
    if (known.empty()) type.register_type(participant);
    dds::Topic* made = participant->create_topic(name, type.get_type_name(), dds::TOPIC_QOS_DEFAULT);
    if (made == nullptr) throw StartError{"DDS refused the topic " + name};
    topics[name] = made;
    return made;
  }
};

Bus::Bus(const BusConfig& config, DiscoveryCallback discovered)
    : impl_{std::make_unique<Impl>(std::move(discovered))} {
  impl_->identity = own_identity(config.role);
  const dds::DomainParticipantQos qos = participant_qos(to_name(impl_->identity), config);
  static const bool prepared = (prepare_process(), true);  // after a profile was read, which may set them too
  (void)prepared;
  if (uses_shared_memory_alone(qos)) impl_->place.emplace(config.domain);
  impl_->participant = join(config, qos, impl_->place ? &*impl_->place : nullptr, &impl_->listener);
  if (impl_->participant == nullptr) {
    throw StartError{"DDS refused a participant in domain " + std::to_string(config.domain) +
                     ": is /dev/shm writable and the domain 0 to 232?"};
  }
  impl_->id = to_id(impl_->participant->guid().guidPrefix);
  impl_->publisher = impl_->participant->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
  impl_->subscriber = impl_->participant->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
  if (impl_->publisher == nullptr || impl_->subscriber == nullptr) {
    close();
    throw StartError{"DDS refused a publisher or subscriber"};
  }
}

Bus::~Bus() { close(); }

const ParticipantId& Bus::id() const { return impl_->id; }
const Identity& Bus::identity() const { return impl_->identity; }

dds::DataWriter* Bus::make_writer(const idl::Topic& topic, std::uint32_t robot, dds::TopicDataType* type) {
  const std::string name = idl::name_for(topic, robot);
  dds::DataWriter* writer = impl_->publisher->create_datawriter(
      impl_->topic(name, type), writer_qos(topic.delivery), nullptr, dds::StatusMask::none());
  if (writer == nullptr) throw StartError{"DDS refused a writer of " + name};
  return writer;
}

void Bus::make_reader(const idl::Topic& topic, std::uint32_t robot, dds::TopicDataType* type,
                      std::shared_ptr<void> sample, Take take) {
  const std::string name = idl::name_for(topic, robot);
  impl_->inboxes.push_back(std::make_unique<Inbox>(std::move(sample), std::move(take)));
  dds::DataReader* reader =
      impl_->subscriber->create_datareader(impl_->topic(name, type), reader_qos(topic.delivery),
                                           impl_->inboxes.back().get(), dds::StatusMask::data_available());
  if (reader == nullptr) throw StartError{"DDS refused a reader of " + name};
  impl_->readers.push_back(reader);
}

void Bus::close() {
  if (impl_->participant == nullptr) return;
  impl_->listener.mute();
  for (dds::DataReader* reader : impl_->readers) reader->set_listener(nullptr, dds::StatusMask::none());
  impl_->participant->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(impl_->participant);
  impl_->participant = nullptr;
  impl_->place.reset();
}

bool detail::write_sample(dds::DataWriter* writer, void* sample) { return is_ok(writer->write(sample)); }

}  // namespace caravan::runtime
