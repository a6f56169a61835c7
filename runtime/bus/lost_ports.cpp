// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/lost_ports.hpp"

#include <memory>
#include <utility>

namespace caravan::runtime {
namespace {

struct Chain : rtps::ChainingTransportDescriptor {
  using rtps::ChainingTransportDescriptor::ChainingTransportDescriptor;
  [[nodiscard]] rtps::TransportInterface* create_transport() const override;
};

class TolerantTransport final : public rtps::ChainingTransport {
 public:
  explicit TolerantTransport(const Chain& descriptor)
      : ChainingTransport(descriptor), descriptor_{descriptor} {}

  rtps::TransportDescriptorInterface* get_configuration() override { return &descriptor_; }
  /// Shared memory has one way out for all addresses. It does not know it again behind a chain, and would add
  /// another one for each address; every message would be sent by all of them.
  bool OpenOutputChannel(rtps::SendResourceList& ways_out, const rtps::Locator_t& address) override {
    has_way_out_ = has_way_out_ || ChainingTransport::OpenOutputChannel(ways_out, address);
    return has_way_out_ && IsLocatorSupported(address);
  }
  bool send(rtps::SenderResource* sender, OutgoingBytes bytes, std::uint32_t size,
            rtps::LocatorsIterator* begin, rtps::LocatorsIterator* end,
            const std::chrono::steady_clock::time_point& timeout) override {
    (void)sender->send(bytes, size, begin, end, timeout);
    return true;
  }
  void receive(rtps::TransportReceiverInterface* next, const rtps::octet* buffer, std::uint32_t size,
               const rtps::Locator_t& local, const rtps::Locator_t& remote) override {
    next->OnDataReceived(buffer, size, local, remote);
  }

 private:
  Chain descriptor_;
  bool has_way_out_ = false;
};

rtps::TransportInterface* Chain::create_transport() const { return new TolerantTransport(*this); }

/// Still a descriptor of shared memory: by its class DDS knows that such addresses can be reached.
struct TolerantDescriptor : rtps::SharedMemTransportDescriptor {
  TolerantDescriptor(const rtps::SharedMemTransportDescriptor& settings,
                     std::shared_ptr<rtps::TransportDescriptorInterface> behind)
      : rtps::SharedMemTransportDescriptor(settings), transport{std::move(behind)} {}
  [[nodiscard]] rtps::TransportInterface* create_transport() const override {
    return Chain{transport}.create_transport();
  }
  std::shared_ptr<rtps::TransportDescriptorInterface> transport;
};

}  // namespace

void tolerate_lost_ports(dds::DomainParticipantQos& qos) {
  for (auto& transport : qos.transport().user_transports) {
    const auto* shared_memory = dynamic_cast<const rtps::SharedMemTransportDescriptor*>(transport.get());
    if (shared_memory != nullptr) transport = std::make_shared<TolerantDescriptor>(*shared_memory, transport);
  }
}

}  // namespace caravan::runtime
