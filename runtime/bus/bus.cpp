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

#include "runtime/bus/discovery.hpp"
#include "runtime/bus/fastdds_version.hpp"
#include "runtime/bus/guid.hpp"
#include "runtime/bus/lost_segments.hpp"
#include "runtime/bus/place.hpp"
#include "runtime/bus/profile.hpp"
#include "runtime/bus/qos.hpp"
#include "runtime/bus/quiet_start.hpp"
#include "runtime/bus/shared_memory_port.hpp"
#include "runtime/bus/start_deadline.hpp"
#include "runtime/config/start_error.hpp"

namespace caravan::runtime {
namespace {

/// Process-wide settings to be made before the first participant.
void prepare_process() {
  // Batch scheduling: an arriving sample does not preempt the sender, which saves half of the context
  // switches.
  const sched_param batch{};
  (void)sched_setscheduler(0, SCHED_BATCH, &batch);  // refused in some containers: slower, not wrong
  // With intraprocess delivery write() would call the reader's callback in the writer's thread, under the
  // writer's locks.
  turn_intraprocess_delivery_off();
  (void)reads_past_lost_segments();  // makes the linker include it
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

}  // namespace

/// A reader's listener: passes on the samples of writers that may claim the topic.
class Bus::Inbox final : public dds::DataReaderListener {
 public:
  Inbox(const idl::Topic& topic, std::string name, Impl& bus, std::shared_ptr<void> sample, Take take)
      : topic_{topic},
        name_{std::move(name)},
        bus_{bus},
        sample_{std::move(sample)},
        take_{std::move(take)} {}

  void on_data_available(dds::DataReader* reader) override;

 private:
  /// None when it has gone: its samples with the same GUID after its return count again.
  std::optional<Sender> sender_of(const dds::SampleInfo& info);

  const idl::Topic topic_;
  const std::string name_;
  Impl& bus_;
  std::shared_ptr<void> sample_;  // reused, so that a step allocates nothing
  Take take_;
  std::vector<Sender> senders_;  // that have written recently
};

struct Bus::Impl {
  Identity identity;
  ParticipantId id;
  DiscoveryListener listener;
  Strangers strangers;
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

std::optional<Sender> Bus::Inbox::sender_of(const dds::SampleInfo& info) {
  constexpr std::size_t kMostSenders = 16;
  const ParticipantId id = to_id(info.sample_identity.writer_guid().guidPrefix);
  const auto known =
      std::find_if(senders_.begin(), senders_.end(), [&](const ParticipantId& one) { return one == id; });
  if (known != senders_.end()) return *known;
  const auto identity = id == bus_.id ? bus_.identity : bus_.listener.identity_of(id);
  if (!identity) return std::nullopt;
  if (senders_.size() == kMostSenders) senders_.clear();
  senders_.push_back({id, claim_of(topic_, *identity)});
  return senders_.back();
}

void Bus::Inbox::on_data_available(dds::DataReader* reader) {
  dds::SampleInfo info;
  while (is_ok(reader->take_next_sample(sample_.get(), &info))) {
    if (!info.valid_data) continue;
    const std::optional<Sender> sender = sender_of(info);
    if (!sender) continue;
    std::optional<Refusal> refusal = detail::refusal_of_this_thread();
    if (sender->claim == Claim::kNone) refusal = Refusal::kNotItsRole;
    if (refusal) {
      bus_.strangers.refuse(*sender, bus_.listener.identity_of(*sender).value_or(Identity{}), name_,
                            *refusal);
    } else {
      take_(sample_.get(), *sender);
    }
  }
}

Bus::Bus(const BusConfig& config, DiscoveryCallback discovered)
    : impl_{std::make_unique<Impl>(std::move(discovered))} {
  impl_->identity = own_identity(config.role);
  const dds::DomainParticipantQos qos = participant_qos(to_name(impl_->identity), config);
  static const bool prepared = (prepare_process(), true);  // after reading a profile, which may set them too
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
  impl_->listener.has(DiscoveryListener::End::kWriter, name);
  return writer;
}

void Bus::make_reader(const idl::Topic& topic, std::uint32_t robot, dds::TopicDataType* type,
                      std::shared_ptr<void> sample, Take take) {
  const std::string name = idl::name_for(topic, robot);
  impl_->inboxes.push_back(std::make_unique<Inbox>(topic, name, *impl_, std::move(sample), std::move(take)));
  dds::DataReader* reader =
      impl_->subscriber->create_datareader(impl_->topic(name, type), reader_qos(topic.delivery),
                                           impl_->inboxes.back().get(), dds::StatusMask::data_available());
  if (reader == nullptr) throw StartError{"DDS refused a reader of " + name};
  impl_->readers.push_back(reader);
  impl_->listener.has(DiscoveryListener::End::kReader, name);
}

void Bus::refuse(const ParticipantId& sender, const idl::Topic& topic, std::uint32_t robot) {
  impl_->strangers.refuse(sender, impl_->listener.identity_of(sender).value_or(Identity{}),
                          idl::name_for(topic, robot), Refusal::kRoleIsHeld);
}

void Bus::forgive(const ParticipantId& holder) { impl_->strangers.forgive(holder); }

std::vector<Stranger> Bus::strangers() const { return impl_->strangers.all(); }

void Bus::close() {
  if (impl_->participant == nullptr) return;
  impl_->listener.mute();
  for (dds::DataReader* reader : impl_->readers) reader->set_listener(nullptr, dds::StatusMask::none());
  impl_->participant->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(impl_->participant);
  impl_->participant = nullptr;
  impl_->place.reset();
}

std::optional<Refusal>& detail::refusal_of_this_thread() {
  thread_local std::optional<Refusal> refusal;
  return refusal;
}

bool detail::write_sample(dds::DataWriter* writer, void* sample) { return is_ok(writer->write(sample)); }

}  // namespace caravan::runtime
