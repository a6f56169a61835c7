// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/quiet_start.hpp"

#include "runtime/bus/profile.hpp"

namespace caravan::runtime {
namespace {

struct QuietDescriptor : rtps::ChainingTransportDescriptor {
  QuietDescriptor(std::shared_ptr<rtps::TransportDescriptorInterface> behind, SendGate may_send)
      : ChainingTransportDescriptor(std::move(behind)), gate{std::move(may_send)} {}
  [[nodiscard]] rtps::TransportInterface* create_transport() const override;
  SendGate gate;
};

class QuietTransport final : public rtps::ChainingTransport {
 public:
  explicit QuietTransport(const QuietDescriptor& descriptor)
      : ChainingTransport(descriptor), descriptor_{descriptor} {}

  rtps::TransportDescriptorInterface* get_configuration() override { return &descriptor_; }
  bool send(rtps::SenderResource* sender, OutgoingBytes bytes, std::uint32_t size,
            rtps::LocatorsIterator* begin, rtps::LocatorsIterator* end,
            const std::chrono::steady_clock::time_point& timeout) override {
    return !*descriptor_.gate || sender->send(bytes, size, begin, end, timeout);
  }
  void receive(rtps::TransportReceiverInterface* next, const rtps::octet* buffer, std::uint32_t size,
               const rtps::Locator_t& local, const rtps::Locator_t& remote) override {
    next->OnDataReceived(buffer, size, local, remote);
  }

 private:
  QuietDescriptor descriptor_;
};

rtps::TransportInterface* QuietDescriptor::create_transport() const { return new QuietTransport(*this); }

}  // namespace

SendGate hold_back_network(dds::DomainParticipantQos& qos) {
  auto gate = std::make_shared<std::atomic<bool>>(false);
  for (auto& transport : qos.transport().user_transports) {
    if (is_shared_memory(transport)) {
      transport = with_whole_messages(transport);
    } else {
      transport = std::make_shared<QuietDescriptor>(transport, gate);
    }
  }
  return gate;
}

}  // namespace caravan::runtime
