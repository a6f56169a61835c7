// SPDX-License-Identifier: Apache-2.0
// The whole loop: an unchanged agent, a bridge, the bytes of a Pioneer over TCP, an emulated Pioneer, and the
// world.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iostream>

#include "build_paths.hpp"
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

TEST_F(ClosedLoop, AControllerFromOutsideDrivesARobotThroughAPioneersBytes) {
  const auto library = std::filesystem::path{CARAVAN_BIN_DIR}.parent_path() / "controllers/braitenberg.so";
  const auto world = start_world(
      room(1, 0) + "[controller]\nlibrary = \"" + library.string() + "\"\ncruise_mps = 0.25\n", "1");
  const Truth truth{bus()};
  const Collector<msg::RobotCommandPubSubType> commands{bus(), idl::kCommand, 1};
  BridgedRobot one = start_bridged(1);
  EXPECT_TRUE(truth.drives(1)) << world->output() << one.output();
  // Its own speed, with one side free; nothing that the paper's agent commands.
  EXPECT_TRUE(commands.first([](const msg::RobotCommand& command) {
    return command.left_mps() == 0.25 || command.right_mps() == 0.25;
  })) << one.output();
  kill_at_once(*one.agent);
  EXPECT_TRUE(truth.rests(1)) << "without its agent it stops";
  one.agent = start_agent(1);
  EXPECT_TRUE(truth.drives(1)) << "and the next one drives it on: " << one.output();
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
