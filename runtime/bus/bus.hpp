// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "idl/topics.hpp"
#include "runtime/bus/checked_type.hpp"
#include "runtime/bus/identity.hpp"
#include "runtime/bus/participant.hpp"
#include "runtime/bus/strangers.hpp"
#include "runtime/bus/transport.hpp"

namespace eprosima::fastdds::dds {
class DataReader;
class DataWriter;
class TopicDataType;
}  // namespace eprosima::fastdds::dds
namespace eprosima::fastdds::rtps {
struct TransportDescriptorInterface;
}

namespace caravan::runtime {

struct BusConfig {
  std::string
      role;  ///< stated in discovery; its first word decides which topics others accept from this process
  std::uint32_t domain = 0;
  double lease_s = 5.0;  ///< a participant silent for this long is gone
  Transport transport = Transport::kSharedMemory;
  /// With kUdp: a transport that replaces loopback_udp() and wraps it; null: loopback_udp() itself.
  std::shared_ptr<eprosima::fastdds::rtps::TransportDescriptorInterface> around_udp = {};
};

/// A participant joined or left, or started to write or read a topic, or stopped writing it. Delivered on a
/// discovery thread: post it to the thread that owns the state.
struct Discovery {
  enum class Kind : std::uint8_t { kJoined, kGone, kWriterFound, kReaderFound, kWriterGone };
  Kind kind = Kind::kJoined;
  ParticipantId participant;
  Identity identity;  ///< of the participant, if known
  std::string topic;  ///< for a writer or reader
};

template <typename PubSubType>
class Writer;

/// One DDS participant. All reader callbacks run on its one receiving thread.
///
/// All entities are created before samples flow. close() ends all callbacks, then deletes everything; the
/// destructor calls it.
/// @throws StartError when DDS refuses an entity
class Bus {
 public:
  using DiscoveryCallback = std::function<void(const Discovery&)>;

  explicit Bus(const BusConfig& config, DiscoveryCallback discovered = {});
  ~Bus();
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  [[nodiscard]] const ParticipantId& id() const;
  [[nodiscard]] const Identity& identity() const;

  /// @tparam Support serialises samples
  /// @param robot fills the "<i>" of the topic's name
  template <typename PubSubType, typename Support = CheckedType<PubSubType>>
  [[nodiscard]] Writer<PubSubType> writer(const idl::Topic& topic, std::uint32_t robot = 0);

  /// Calls `handle(sample, sender)` for each sample as it arrives, if its bytes are of the type and its
  /// writer may claim the topic (Sender::claim is not kNone). All others are refused: counted, and logged
  /// once.
  template <typename PubSubType, typename Handler>
  void reader(const idl::Topic& topic, std::uint32_t robot, Handler handle);

  /// Counts a sample as refused because another participant holds the role. Called by the owner of the
  /// Tenure.
  void refuse(const ParticipantId& sender, const idl::Topic& topic, std::uint32_t robot = 0);
  /// `holder`, whose samples were refused until now, has become the holder of the role.
  void forgive(const ParticipantId& holder);
  /// Participants whose samples were refused.
  [[nodiscard]] std::vector<Stranger> strangers() const;

  void close();

 private:
  struct Impl;
  class Inbox;  // a reader's listener
  using Take = std::function<void(void* sample, const Sender& sender)>;

  eprosima::fastdds::dds::DataWriter* make_writer(const idl::Topic& topic, std::uint32_t robot,
                                                  eprosima::fastdds::dds::TopicDataType* type);
  void make_reader(const idl::Topic& topic, std::uint32_t robot, eprosima::fastdds::dds::TopicDataType* type,
                   std::shared_ptr<void> sample, Take take);

  std::unique_ptr<Impl> impl_;
};

/// Writes samples of one topic.
template <typename PubSubType>
class Writer {
 public:
  using Sample = typename PubSubType::type;
  Writer() = default;
  explicit Writer(eprosima::fastdds::dds::DataWriter* writer) : writer_{writer} {}
  /// False when DDS did not accept the sample; the caller counts or logs it.
  bool write(Sample& sample);

 private:
  eprosima::fastdds::dds::DataWriter* writer_ = nullptr;
};

namespace detail {
bool write_sample(eprosima::fastdds::dds::DataWriter* writer, void* sample);
}

template <typename PubSubType>
bool Writer<PubSubType>::write(Sample& sample) {
  return detail::write_sample(writer_, &sample);
}

template <typename PubSubType, typename Support>
Writer<PubSubType> Bus::writer(const idl::Topic& topic, std::uint32_t robot) {
  return Writer<PubSubType>{make_writer(topic, robot, new Support{})};
}

template <typename PubSubType, typename Handler>
void Bus::reader(const idl::Topic& topic, std::uint32_t robot, Handler handle) {
  using Sample = typename PubSubType::type;
  make_reader(topic, robot, new CheckedType<PubSubType>{}, std::make_shared<Sample>(),
              [handle = std::move(handle)](void* sample, const Sender& sender) mutable {
                handle(*static_cast<const Sample*>(sample), sender);
              });
}

}  // namespace caravan::runtime
