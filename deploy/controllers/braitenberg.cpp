// SPDX-License-Identifier: Apache-2.0
// The shortest controller: vehicle 3b of V. Braitenberg, "Vehicles: Experiments in Synthetic Psychology", MIT
// Press, 1984. What the sonars of one side see brakes the wheel of the other side, so the robot turns away
// from it.
#include <algorithm>
#include <caravan/controller.hpp>

namespace {

class Vehicle3b final : public caravan::Controller {
 public:
  Vehicle3b(const caravan::Robot& /*robot*/, caravan::Parameters& parameters)
      : cruise_mps_{parameters.number("cruise_mps", 0.5, {0.0, 1.6})},
        sight_m_{parameters.number("sight_m", 1.5, {0.1, 5.0})} {}

  caravan::Outputs step(const caravan::Inputs& inputs) override {
    const auto& range_m = inputs.sensors.sonar_range_m;
    // 0: nothing in sight, 1: something touches the sonar. A range that is not known (NaN) counts as nothing.
    const auto closeness = [&](std::size_t first, std::size_t last) {
      double nearest_m = sight_m_;
      for (std::size_t sonar = first; sonar <= last; ++sonar) nearest_m = std::min(nearest_m, range_m[sonar]);
      return 1.0 - nearest_m / sight_m_;
    };
    caravan::Outputs outputs;
    outputs.right_mps =
        cruise_mps_ * (1.0 - 2.0 * closeness(0, 3));  // sonars 0 to 3 look ahead and to the left
    outputs.left_mps = cruise_mps_ * (1.0 - 2.4 * closeness(4, 7));  // not alike: it turns in front of a wall
    return outputs;
  }

 private:
  double cruise_mps_;
  double sight_m_;
};

}  // namespace

CARAVAN_CONTROLLER(Vehicle3b, "braitenberg")
