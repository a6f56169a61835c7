// SPDX-License-Identifier: Apache-2.0
// Two participants in lockstep over a transport that drops packets: the reliable protocol must repair the
// losses soon.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <iostream>

#include "idl/robot_types.hpp"
#include "idl/stamp.hpp"
#include "runtime/bus/bus.hpp"
#include "runtime/bus/fastdds_version.hpp"
#include "runtime/bus/qos.hpp"
#include "runtime/host/domain_lock.hpp"
#include "tests/support/patience.hpp"

namespace caravan::test {
namespace {

namespace msg = caravan_interfaces::msg;
namespace rtps = runtime::rtps;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// UDP on 127.0.0.1 that drops every n-th packet after `drop_every` is set.
struct LossyDescriptor : rtps::ChainingTransportDescriptor {
  LossyDescriptor() : ChainingTransportDescriptor(runtime::loopback_udp()) {}
  [[nodiscard]] rtps::TransportInterface* create_transport() const override;
  std::shared_ptr<std::atomic<int>> drop_every = std::make_shared<std::atomic<int>>(0);
  std::shared_ptr<std::atomic<int>> dropped = std::make_shared<std::atomic<int>>(0);
};

class LossyTransport : public rtps::ChainingTransport {
 public:
  explicit LossyTransport(const LossyDescriptor& descriptor)
      : ChainingTransport(descriptor), descriptor_{descriptor} {}

  rtps::TransportDescriptorInterface* get_configuration() override { return &descriptor_; }
  bool send(rtps::SenderResource* low_sender, runtime::OutgoingBytes bytes, std::uint32_t size,
            rtps::LocatorsIterator* begin, rtps::LocatorsIterator* end,
            const Clock::time_point& timeout) override {
    const int drop_every = *descriptor_.drop_every;
    if (drop_every > 0 && ++sent_ % drop_every == 0) {
      ++*descriptor_.dropped;
      return true;
    }
    return low_sender->send(bytes, size, begin, end, timeout);
  }
  void receive(rtps::TransportReceiverInterface* next, const rtps::octet* buffer, std::uint32_t size,
               const rtps::Locator_t& local, const rtps::Locator_t& remote) override {
    next->OnDataReceived(buffer, size, local, remote);
  }

 private:
  LossyDescriptor descriptor_;
  std::atomic<int> sent_{0};
};

rtps::TransportInterface* LossyDescriptor::create_transport() const { return new LossyTransport(*this); }

TEST(LostSamples, HoldUpTheLockstepForLessThanHalfASecond) {
  const runtime::DomainLock lock{std::nullopt};
  const auto lossy = std::make_shared<LossyDescriptor>();
  runtime::Bus world{
      {.role = "world", .domain = lock.domain(), .transport = runtime::Transport::kUdp, .around_udp = lossy}};
  runtime::Bus robot{{.role = "robot", .domain = lock.domain(), .transport = runtime::Transport::kUdp}};
  constexpr int kRounds = 120;
  auto sensors = world.writer<msg::SensorFramePubSubType>(idl::kSensors, 1);
  auto commands = robot.writer<msg::RobotCommandPubSubType>(idl::kCommand, 1);
  robot.reader<msg::SensorFramePubSubType>(idl::kSensors, 1, [&](const msg::SensorFrame& frame, const auto&) {
    msg::RobotCommand command;
    command.stamp(frame.stamp());
    commands.write(command);
  });
  std::promise<void> finished;
  std::vector<Clock::duration> rounds;  // used by the receiving thread until `finished`
  Clock::time_point began;
  const auto send = [&](std::size_t round) {
    msg::SensorFrame frame;
    frame.stamp(idl::to_wire(std::chrono::milliseconds{round}));
    began = Clock::now();
    sensors.write(frame);
  };
  world.reader<msg::RobotCommandPubSubType>(
      idl::kCommand, 1, [&](const msg::RobotCommand& command, const auto&) {
        if (idl::to_time(command.stamp()) != std::chrono::milliseconds{rounds.size()}) return;
        rounds.push_back(Clock::now() - began);
        if (rounds.size() == 1) *lossy->drop_every = 8;  // only now: the test is not about discovery
        if (rounds.size() == kRounds) return finished.set_value();
        send(rounds.size());
      });
  send(0);

  auto done = finished.get_future();
  ASSERT_TRUE(eventually([&] { return done.wait_for(0s) == std::future_status::ready; }, kPatience))
      << rounds.size() << ' ' << *lossy->dropped;
  world.close();
  robot.close();
  std::vector<Clock::duration> held_up;
  std::copy_if(rounds.begin() + 1, rounds.end(), std::back_inserter(held_up),
               [](Clock::duration one) { return one > 100ms; });
  ASSERT_FALSE(held_up.empty()) << *lossy->dropped << " packets were dropped and nobody noticed";
  // The median, so that other load on the machine does not fail the test. The default heartbeat would make it
  // 3 s.
  std::nth_element(held_up.begin(), held_up.begin() + static_cast<long>(held_up.size() / 2), held_up.end());
  const auto median = held_up[held_up.size() / 2];
  EXPECT_LT(median, 500ms * slowness());
  std::cout << held_up.size() << " of " << kRounds << " rounds were held up, median "
            << std::chrono::duration<double>(median).count() << " s\n";
}

}  // namespace
}  // namespace caravan::test
