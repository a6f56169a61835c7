// SPDX-License-Identifier: Apache-2.0
// The small scenario with Pioneers: two robots each have a bridge, the world itself serves the other two.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iostream>

#include "build_paths.hpp"
#include "tests/system/bridge/support/field.hpp"

namespace caravan::test {
namespace {

using namespace std::chrono_literals;

/// deploy/scenarios/small.toml in real time, with the speed and the gripper patience of real robots.
std::string small_field() {
  std::string text = read_file(std::filesystem::path{CARAVAN_SOURCE_DIR} / "deploy/scenarios/small.toml");
  text = replaced(text, "mode = \"full\"",
                  "mode = \"full\"\ncruise_mps = 0.5\nslow_mps = 0.25\ngripper_patience_s = 3.0");
  text = replaced(text, "items = 4", "items = 4\npacing = \"free\"");
  return text + "\n[bridge]\norigin_latitude_deg = 48.137\norigin_longitude_deg = 11.575\nx_axis_rad = 0.3\n";
}

class ClosedLoopLong : public Field {};

TEST_F(ClosedLoopLong, AMixedFleetDeliversTheItemsOfTheSmallScenario) {
  const auto world = start_world(small_field(), "1,2");
  const auto radio = start("radio_emulator", {"--bodies", "1,2"});
  const Truth truth{bus()};
  const BridgedRobot one = start_bridged(1);
  const BridgedRobot two = start_bridged(2);
  const auto three = start_agent(3);
  const auto four = start_agent(4);
  std::uint32_t told = 0;
  EXPECT_TRUE(eventually(
      [&] {
        if (const std::uint32_t items = truth.items_delivered(); items > told) {
          told = items;
          std::cout << items << " delivered at " << std::chrono::duration<double>(truth.now()).count()
                    << " s\n";
        }
        return told == 4;
      },
      1400s))
      << world->output() << one.output() << two.output() << three->output() << four->output();
}

}  // namespace
}  // namespace caravan::test
