// SPDX-License-Identifier: Apache-2.0
/// Workaround for a defect of Fast DDS 3.1.2; included only by fastdds_3.hpp.
#pragma once

#include <chrono>
#include <cstdint>
#include <fastdds/rtps/transport/ChainingTransport.hpp>
#include <fastdds/rtps/transport/ChainingTransportDescriptor.hpp>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.hpp>
#include <memory>
#include <vector>

namespace caravan::runtime {
namespace rtps = eprosima::fastdds::rtps;

/// The bytes that a transport is to send.
using OutgoingBytes = const std::vector<rtps::NetworkBuffer>&;

/// Shared memory without the statistics that DDS appends to each message.
///
/// 3.1.2 reserves room for them and copies nothing into it (3.1.3 fixes it): the receiver takes the stale
/// bytes there for more of the message, and often does not count the message as a sign of life.
class WholeMessages final : public rtps::ChainingTransport {
 public:
  explicit WholeMessages(const rtps::SharedMemTransportDescriptor& settings)
      : ChainingTransport(Chain{std::make_shared<rtps::SharedMemTransportDescriptor>(settings)}) {}
  rtps::TransportDescriptorInterface* get_configuration() override {
    return low_level_transport_->get_configuration();
  }
  bool send(rtps::SenderResource* sender, OutgoingBytes bytes, std::uint32_t size,
            rtps::LocatorsIterator* begin, rtps::LocatorsIterator* end,
            const std::chrono::steady_clock::time_point& timeout) override {
    constexpr std::uint32_t kStatisticsSize = 60;
    constexpr rtps::octet kStatistics = 0x80;
    const rtps::NetworkBuffer& last = bytes.back();
    if (last.size != kStatisticsSize || *static_cast<const rtps::octet*>(last.buffer) != kStatistics)
      return sender->send(bytes, size, begin, end, timeout);
    const std::vector<rtps::NetworkBuffer> message(bytes.begin(), bytes.end() - 1);
    return sender->send(message, size - last.size, begin, end, timeout);
  }
  void receive(rtps::TransportReceiverInterface* next, const rtps::octet* buffer, std::uint32_t size,
               const rtps::Locator_t& local, const rtps::Locator_t& remote) override {
    next->OnDataReceived(buffer, size, local, remote);
  }

 private:
  struct Chain final : rtps::ChainingTransportDescriptor {
    using ChainingTransportDescriptor::ChainingTransportDescriptor;
    [[nodiscard]] rtps::TransportInterface* create_transport() const override { return nullptr; }
  };
};

/// DDS still treats it as shared memory, because it checks the descriptor's class.
struct WholeMessagesDescriptor final : rtps::SharedMemTransportDescriptor {
  explicit WholeMessagesDescriptor(const rtps::SharedMemTransportDescriptor& settings)
      : rtps::SharedMemTransportDescriptor(settings) {}
  [[nodiscard]] rtps::TransportInterface* create_transport() const override {
    return new WholeMessages(*this);
  }
};

}  // namespace caravan::runtime
