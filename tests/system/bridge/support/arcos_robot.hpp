// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hardware_bridge/core/arcos/command.hpp"
#include "hardware_bridge/core/arcos/odometry.hpp"
#include "tests/system/bridge/support/field.hpp"

namespace caravan::test {

/// An emulated Pioneer in a running world. The test takes the place of its host.
class ArcosRobot : public Field {
 protected:
  void SetUp() override {
    world_ = start_world(room(1, 0), "1");
    robot_ = start_robot(1);
    ASSERT_TRUE(world_->prints("started robots=1", kPatience))
        << world_->output() << robot_.process->output();
    ASSERT_TRUE(truth_.is_there());
  }
  static bridge::arcos::Bytes wheels(double left_mps, double right_mps) {
    return bridge::arcos::encode(bridge::arcos::Order::kWheelSpeeds,
                                 bridge::arcos::wheel_speeds_argument(left_mps, right_mps));
  }

  std::unique_ptr<Process> world_;
  Robot robot_;
  Truth truth_{bus()};
};

}  // namespace caravan::test
