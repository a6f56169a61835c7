// SPDX-License-Identifier: Apache-2.0
// The whole loop: an unchanged agent, a bridge, the bytes of a Pioneer over TCP, an emulated Pioneer, and the
// world.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iostream>

#include "tests/system/bridge/support/field.hpp"

namespace caravan::test {
namespace {

namespace msg = caravan_interfaces::msg;
using namespace std::chrono_literals;

using ClosedLoop = Field;

TEST_F(ClosedLoop, AnUnmodifiedAgentDeliversAnItemThroughAPioneersBytes) {
  const auto world = start_world(room(1, 1), "1");
  const auto radio = start("radio_emulator", {"--bodies", "1"});
  const Truth truth{bus()};
  const BridgedRobot one = start_bridged(1);
  EXPECT_TRUE(eventually([&] { return truth.items_delivered() == 1; }, 280s))
      << world->output() << one.robot.process->output() << one.bridge->output() << one.agent->output();
  std::cout << "delivered after " << std::chrono::duration<double>(truth.now()).count() << " s\n";
}

TEST_F(ClosedLoop, AMixedFleetExchangesPathsByRadio) {
  const auto world = start_world(room(2, 0), "1");
  const auto radio = start("radio_emulator", {"--bodies", "1"});
  const Truth truth{bus()};
  const Collector<msg::TelemetryPubSubType> telemetry_1{bus(), idl::kTelemetry, 1};
  const Collector<msg::TelemetryPubSubType> telemetry_2{bus(), idl::kTelemetry, 2};
  const BridgedRobot one = start_bridged(1);
  const auto other = start_agent(2);
  const auto exchanged = [](const auto& telemetry, std::uint32_t partner) {
    for (const msg::Telemetry& sample : telemetry.samples()) {
      for (const msg::ExchangeReport& exchange : sample.exchanges()) {
        if (exchange.completed() && exchange.partner() == partner) return true;
      }
    }
    return false;
  };
  EXPECT_TRUE(eventually([&] { return exchanged(telemetry_1, 2) && exchanged(telemetry_2, 1); }, 280s))
      << world->output() << one.bridge->output() << one.agent->output() << other->output();
  std::cout << "exchanged within " << std::chrono::duration<double>(truth.now()).count() << " s\n";
}

}  // namespace
}  // namespace caravan::test
