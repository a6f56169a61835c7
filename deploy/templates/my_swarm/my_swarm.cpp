// The controller of one robot: what it does in a step, given what it senses and hears.
#include <algorithm>
#include <array>
#include <caravan/controller.hpp>
#include <chrono>
#include <string>

namespace {

using namespace std::chrono_literals;

/// Wanders, turns away from obstacles, and says hello to the robots in radio range once a second.
class MySwarm final : public caravan::Controller {
 public:
  /// The keys of the scenario's table [controller], with defaults and limits. Other keys are refused.
  MySwarm(const caravan::Robot& robot, caravan::Parameters& parameters)
      : id_{static_cast<std::uint8_t>(robot.id)},
        cruise_mps_{parameters.number("cruise_mps", 0.5, {0.0, robot.body.wheel_limit_mps})},
        distance_m_{parameters.number("distance_m", 1.0, {0.1, robot.sonars.range_m})},
        random_{robot.random()} {}

  caravan::Outputs step(const caravan::Inputs& inputs) override {
    caravan::Outputs outputs;
    drive(inputs.sensors, outputs);
    talk(inputs, outputs);
    return outputs;
  }

 private:
  /// Sonars 0 to 7 look ahead, from the left to the right. A range that is not known (NaN) counts as far.
  void drive(const caravan::Sensors& sensors, caravan::Outputs& outputs) {
    double nearest_m = distance_m_;
    for (std::size_t sonar = 1; sonar <= 6; ++sonar)
      nearest_m = std::min(nearest_m, sensors.sonar_range_m[sonar]);
    if (nearest_m < distance_m_) {
      if (turn_ == 0.0) turn_ = random_.chance(0.5) ? 1.0 : -1.0;  // keeps turning the same way
    } else {
      turn_ = 0.0;
    }
    outputs.left_mps = turn_ == 0.0 ? cruise_mps_ : -turn_ * 0.5 * cruise_mps_;
    outputs.right_mps = turn_ == 0.0 ? cruise_mps_ : turn_ * 0.5 * cruise_mps_;
  }

  /// A frame has one byte: who says hello. The first hello from each robot is an event of the run.
  void talk(const caravan::Inputs& inputs, caravan::Outputs& outputs) {
    if (inputs.now >= next_hello_) {
      next_hello_ = inputs.now + 1s;
      outputs.frames.push_back({.channel = 0, .bytes = {id_}});
    }
    for (const caravan::ReceivedFrame& frame : inputs.heard) {
      if (frame.bytes.size() != 1 || met_[frame.bytes[0]]) continue;
      met_[frame.bytes[0]] = true;
      if (!outputs.report) outputs.report.emplace();
      outputs.report->events.push_back({"met", "robot=" + std::to_string(frame.bytes[0])});
    }
  }

  std::uint8_t id_;
  double cruise_mps_;
  double distance_m_;
  caravan::Random random_;
  double turn_ = 0.0;  ///< 1: to the left, -1: to the right, 0: straight ahead
  caravan::Time next_hello_{0};
  std::array<bool, 256> met_{};
};

}  // namespace

CARAVAN_CONTROLLER(MySwarm, "my_swarm")
