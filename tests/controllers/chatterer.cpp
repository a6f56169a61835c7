// SPDX-License-Identifier: Apache-2.0
// A controller that wanders, broadcasts random bytes, and lets received bytes change its course: a run
// depends on every input.
#include <algorithm>
#include <caravan/controller.hpp>
#include <cmath>

namespace {

class Chatterer final : public caravan::Controller {
 public:
  Chatterer(const caravan::Robot& robot, caravan::Parameters& parameters)
      : random_{robot.random()},
        limit_mps_{robot.body.wheel_limit_mps},
        cruise_mps_{parameters.number("cruise_mps", 0.4, {0.0, 1.0})} {}

  caravan::Outputs step(const caravan::Inputs& inputs) override {
    for (const caravan::ReceivedFrame& frame : inputs.heard) {
      for (const std::uint8_t byte : frame.bytes) turn_ += 0.001 * (byte - 127);
    }
    const auto& sonars = inputs.sensors.sonar_range_m;
    const double ahead_m = std::min({sonars[2], sonars[3], sonars[4], sonars[5]});
    turn_ = ahead_m < 0.8 ? 0.4 : 0.95 * turn_ + random_.uniform(-0.05, 0.05);
    const double speed_mps = ahead_m < 0.8 ? 0.0 : cruise_mps_;
    caravan::Outputs outputs;
    outputs.left_mps = std::clamp(speed_mps - turn_, -limit_mps_, limit_mps_);
    outputs.right_mps = std::clamp(speed_mps + turn_, -limit_mps_, limit_mps_);
    outputs.gripper_closed = true;
    outputs.frames.push_back({0, {static_cast<std::uint8_t>(random_.word() % 256)}});
    if (!reported_) outputs.report.emplace().events.push_back({"began", "turn=" + std::to_string(turn_)});
    reported_ = true;
    return outputs;
  }

 private:
  caravan::Random random_;
  double limit_mps_;
  double cruise_mps_;
  double turn_ = 0.0;
  bool reported_ = false;
};

}  // namespace

CARAVAN_CONTROLLER(Chatterer, "chatterer")
