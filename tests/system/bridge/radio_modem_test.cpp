// SPDX-License-Identifier: Apache-2.0
// The radio topics of two robots, each behind a modem. The modems reach each other by UDP on this machine or
// by serial ports.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <thread>

#include "tests/system/bridge/support/field.hpp"
#include "tests/system/bridge/support/serial_cable.hpp"

namespace caravan::test {
namespace {

namespace msg = caravan_interfaces::msg;
using namespace std::chrono_literals;
using ::testing::HasSubstr;

/// A UDP port that is free at the moment.
std::uint16_t free_udp_port() {
  const int probe = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* name = reinterpret_cast<sockaddr*>(&address);
  EXPECT_EQ(bind(probe, name, size), 0);
  EXPECT_EQ(getsockname(probe, name, &size), 0);
  close(probe);
  return ntohs(address.sin_port);
}

msg::RadioTransmit transmission(std::uint32_t tuned, std::uint32_t channel, std::vector<std::uint8_t> bytes) {
  static std::int64_t sent = 0;
  msg::RadioTransmit sample;
  sample.stamp(idl::to_wire(++sent * 1ms));
  sample.session(7);
  sample.tuned_channel(tuned);
  msg::RadioFrame frame;
  frame.channel(channel);
  frame.bytes(std::move(bytes));
  sample.frames().push_back(std::move(frame));
  return sample;
}

class RadioModemProcess : public Field {
 protected:
  /// Starts a modem for each of two robots.
  void start_modems(const std::array<std::string, 2>& addresses) {
    write_file(scenario_file(), room(2, 0) + "[radio]\nmtu_bytes = 32\nchannel_count = 126\n");
    for (const std::size_t i : {0U, 1U}) {
      modems_.push_back(
          start("radio_modem_bridge", {"--robot", std::to_string(i + 1), "--modem", addresses.at(i)}));
      ASSERT_TRUE(modems_.back()->prints("modem ready: mtu=32", kPatience)) << modems_.back()->output();
    }
    for (const std::uint32_t robot : {1U, 2U}) {
      transmits_.push_back(bus_.writer<msg::RadioTransmitPubSubType>(idl::kRadioTransmit, robot));
    }
  }
  /// Sends the bytes repeatedly until robot 2 has received them: a frame that is on the air while a radio
  /// changes its channel is lost.
  [[nodiscard]] bool robot_2_hears(const std::vector<std::uint8_t>& bytes, std::uint32_t tuned,
                                   std::uint32_t channel, std::chrono::milliseconds patience) {
    return eventually(
        [&] {
          auto there = transmission(tuned, tuned, {0});
          transmits_[1].write(there);
          auto said = transmission(0, channel, bytes);
          transmits_[0].write(said);
          std::this_thread::sleep_for(20ms);
          for (const msg::RadioReceive& sample : heard_.samples()) {
            for (const msg::ReceivedFrame& frame : sample.frames()) {
              if (frame.bytes() == bytes && frame.channel() == channel) return true;
            }
          }
          return false;
        },
        patience);
  }

  void expect_frames_of_the_tuned_channel_up_to_the_mtu() {
    EXPECT_TRUE(robot_2_hears(std::vector<std::uint8_t>(32, 5), 0, 0, kPatience)) << modems_[0]->output();
    EXPECT_TRUE(robot_2_hears({1, 2, 3}, 9, 9, kPatience)) << "after both have changed to it";
    EXPECT_FALSE(robot_2_hears({4, 4, 4}, 9, 8, 1s)) << "another channel";
    EXPECT_FALSE(robot_2_hears(std::vector<std::uint8_t>(33, 6), 0, 0, 1s)) << "over the MTU";
    EXPECT_THAT(modems_[0]->output(), HasSubstr("over the MTU"));
  }

  std::vector<std::unique_ptr<Process>> modems_;
  Collector<msg::RadioReceivePubSubType> heard_{bus(), idl::kRadioReceive, 2};
  runtime::Bus bus_{bus()};
  std::vector<runtime::Writer<msg::RadioTransmitPubSubType>> transmits_;
};

TEST_F(RadioModemProcess, CarriesFramesByUdp) {
  const std::string air = "udp:" + std::to_string(free_udp_port());
  start_modems({air, air});
  expect_frames_of_the_tuned_channel_up_to_the_mtu();
}

TEST_F(RadioModemProcess, OfTwoForOneRobotTheSecondEndsAndNamesTheFirst) {
  const std::string air = "udp:" + std::to_string(free_udp_port());
  start_modems({air, air});
  const auto third = start("radio_modem_bridge", {"--robot", "1", "--modem", air});
  EXPECT_EQ(third->wait(kPatience), 2) << third->output();
  EXPECT_THAT(third->output(), HasSubstr("robot 1 is already served by radio_modem_bridge 1, pid " +
                                         std::to_string(modems_[0]->pid())));
}

// Two connected serial ports stand for a pair of transparent radio modules.
TEST_F(RadioModemProcess, CarriesFramesBySerialPortsAlsoAfterTheyWereUnplugged) {
  if (const std::string reason = no_terminals_because(); !reason.empty()) {
    GTEST_SKIP() << "no pseudo-terminals here: " << reason;
  }
  const std::array<std::string, 2> ports{folder_ / "ttyRadio1", folder_ / "ttyRadio2"};
  const auto plugged_in = [&](const std::string& log) {
    auto socat = std::make_unique<PatientProcess>(
        std::vector<std::string>{"/usr/bin/socat", "pty,raw,echo=0,link=" + ports[0],
                                 "pty,raw,echo=0,link=" + ports[1]},
        folder_ / log);
    EXPECT_TRUE(eventually(
        [&] { return std::filesystem::exists(ports[0]) && std::filesystem::exists(ports[1]); }, kPatience))
        << socat->output();
    return socat;
  };
  auto modules = plugged_in("modules_1.log");
  start_modems(ports);
  expect_frames_of_the_tuned_channel_up_to_the_mtu();
  modules.reset();
  for (const auto& modem : modems_) EXPECT_TRUE(modem->prints("trying again", kPatience)) << modem->output();
  for (const std::string& port : ports) std::filesystem::remove(port);
  modules = plugged_in("modules_2.log");
  EXPECT_TRUE(robot_2_hears({7, 8, 9}, 9, 9, kPatience)) << modems_[0]->output() << modems_[1]->output();
}

}  // namespace
}  // namespace caravan::test
