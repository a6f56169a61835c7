// SPDX-License-Identifier: Apache-2.0
// The real radio emulator; the test takes the place of the world and of two agents.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/host/domain_lock.hpp"
#include "tests/system/support/bus_player.hpp"

namespace caravan::test {
namespace {

namespace msg = caravan_interfaces::msg;
using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::uint64_t kSession = 7;

class RadioProcess : public ::testing::Test {
 protected:
  RadioProcess()
      : radio_{{"radio_emulator", "--scenario", scenario("small.toml"), "--domain",
                std::to_string(lock_.domain())},
               folder_ / "radio.log"} {
    truths_ = world_.writer<msg::WorldTruthPubSubType>(idl::kTruth);
    for (const std::uint32_t robot : {1U, 2U}) {
      transmits_[robot] = agents_.writer<msg::RadioTransmitPubSubType>(idl::kRadioTransmit, robot);
    }
  }

  /// One step with robots 1 and 2 at this distance, robot 1 sending on `channel` and robot 2 tuned to
  /// `tuned`.
  /// @return the receivers that the radio names
  std::vector<std::uint32_t> receivers(double distance_m, std::uint32_t channel, std::uint32_t tuned) {
    stamp_ += 32ms;
    transmit(1, 0, {channel});
    transmit(2, tuned, {});
    msg::WorldTruth truth;
    truth.stamp(idl::to_wire(stamp_));
    truth.next_stamp(idl::to_wire(stamp_ + 32ms));
    truth.session(kSession);
    truth.members({1, 2});
    truth.robots({at(1, 0.0), at(2, distance_m)});
    truths_.write(truth);
    const auto step =
        steps_.first([&](const msg::RadioStep& one) { return idl::to_time(one.stamp()) == stamp_; });
    EXPECT_TRUE(step) << "the radio did not answer; its log:\n" << radio_.output();
    return step ? step->receivers() : std::vector<std::uint32_t>{};
  }

  runtime::DomainLock lock_{std::nullopt};
  ScratchFolder folder_;
  Process radio_;
  const runtime::BusConfig bus_config_{.role = "test", .domain = lock_.domain()};
  runtime::Bus world_{{.role = "world_server", .domain = lock_.domain()}};
  runtime::Bus agents_{bus_config_};
  Collector<msg::RadioStepPubSubType> steps_{bus_config_, idl::kRadioStep};
  Collector<msg::RadioReceivePubSubType> received_{bus_config_, idl::kRadioReceive, 2};

 private:
  static msg::RobotTruth at(std::uint32_t robot, double x_m) {
    msg::RobotTruth truth;
    truth.robot(robot);
    truth.x_m(x_m);
    return truth;
  }
  void transmit(std::uint32_t robot, std::uint32_t tuned, const std::vector<std::uint32_t>& channels) {
    msg::RadioTransmit sample;
    sample.stamp(idl::to_wire(stamp_));
    sample.session(kSession);
    sample.tuned_channel(tuned);
    for (const std::uint32_t channel : channels) {
      msg::RadioFrame frame;
      frame.channel(channel);
      frame.bytes({1, 2, 3});
      sample.frames().push_back(frame);
    }
    transmits_.at(robot).write(sample);
  }

  std::chrono::nanoseconds stamp_{0};
  runtime::Writer<msg::WorldTruthPubSubType> truths_;
  std::map<std::uint32_t, runtime::Writer<msg::RadioTransmitPubSubType>> transmits_;
};

TEST_F(RadioProcess, CarriesAFrameAcrossExactlyTwoMetresOnOneChannel) {
  EXPECT_THAT(receivers(2.00, 0, 0), ElementsAre(2));
  const auto heard = received_.first([](const msg::RadioReceive&) { return true; });
  ASSERT_TRUE(heard);
  ASSERT_EQ(heard->frames().size(), 1U);
  EXPECT_THAT(heard->frames()[0].bytes(), ElementsAre(1, 2, 3));
}

TEST_F(RadioProcess, CarriesNothingBeyondTwoMetres) { EXPECT_THAT(receivers(2.01, 0, 0), IsEmpty()); }

TEST_F(RadioProcess, CarriesNothingToAnotherChannel) {
  EXPECT_THAT(receivers(1.0, 0, 5), IsEmpty());
  EXPECT_THAT(receivers(1.0, 5, 0), IsEmpty());
  EXPECT_THAT(receivers(1.0, 5, 5), ElementsAre(2));
}

}  // namespace
}  // namespace caravan::test
