// SPDX-License-Identifier: Apache-2.0
// Whole agents under the conditions of hardware: ten frames a second, late and lost frames, sonars that fire
// in turn or not at all. Bridge, emulated Pioneer, ODE world and agent run in one process and in simulated
// time.
#include <gtest/gtest.h>

#include <deque>
#include <iostream>
#include <limits>

#include "hardware_bridge/core/host/bridge.hpp"
#include "hardware_bridge/core/robot/gps_receiver.hpp"
#include "hardware_bridge/core/robot/microcontroller.hpp"
#include "robot_agent/config/agent_config.hpp"
#include "robot_agent/core/agent.hpp"
#include "runtime/pure/random.hpp"
#include "world_server/config/world_config.hpp"
#include "world_server/world.hpp"

namespace caravan {
namespace {

using bridge::Time;
using namespace std::chrono_literals;

constexpr const char* kRoom = R"(
name = "room"
[robots]
count = 1
source_m = [-2.5, -2.5]
destination_m = [2.5, 2.0]
[algorithm]
cruise_mps = 0.6
gripper_patience_s = 2.0
[experiment]
items = 1
max_time_s = 1800.0
[world]
step_s = 0.02
arena_m = [9.0, 9.0]
start_low_m = [-3.2, -3.2]
start_high_m = [-1.8, -1.8]
[[world.box]]
centre_m = [0.0, 0.0]
size_m = [1.2, 1.2]
)";

struct Conditions {
  std::string name;
  Time jitter{0};     // greatest delay of a SIP
  double lost = 0.0;  // share of SIPs that are lost
  std::vector<std::size_t> dead_sonars = {};
};

class Hardware {
 public:
  Hardware(const Conditions& conditions, std::uint64_t seed)
      : conditions_{conditions},
        random_{seed},
        scenario_{runtime::TomlDocument::parse("seed = " + std::to_string(seed) + "\n" + kRoom, "room.toml")},
        world_{world::load_world_config(scenario_)},
        agent_{agent::load_config(scenario_, 1)} {
    robot_.connected(now_);
    bridge_.robot_up(now_);
  }

  void step() {
    now_ += 20ms;
    sense();
    const bridge::BodyDrive drive = robot_.drive(now_);
    commands_[0] = world::Command{drive.left_mps, drive.right_mps, drive.gripper_closed};
    world_.advance(commands_);
    touched_ += world_.contacts().size();
    carry_bytes();
    bridge_.tick(now_);
    act(bridge_.take_effects());
  }
  [[nodiscard]] bool delivered() const { return world_.items_delivered() > 0; }
  [[nodiscard]] double now_s() const { return bridge::seconds(now_); }
  [[nodiscard]] std::size_t contacts() const { return touched_; }
  [[nodiscard]] std::size_t frames() const { return frames_; }

 private:
  void sense() {
    const Sensors sensors = world_.sense(1);
    robot_.sense({.sonar_range_m = sensors.sonar_range_m,
                  .yaw_WB_rad = sensors.yaw_rad,
                  .left_wheel_rad = sensors.left_wheel_rad,
                  .right_wheel_rad = sensors.right_wheel_rad,
                  .holding = sensors.holding},
                 now_);
    gps_.sense({sensors.position.x_m, sensors.position.y_m}, now_);
    const std::string lines = gps_.take_lines(now_);
    bridge_.gps_says({reinterpret_cast<const std::uint8_t*>(lines.data()), lines.size()}, now_);
  }
  void carry_bytes() {
    bridge::arcos::Bytes bytes = robot_.take_output();
    if (!bytes.empty() && !(now_ > 2s && random_.chance(conditions_.lost))) {
      const Time late{
          static_cast<Time::rep>(random_.unit() * static_cast<double>(conditions_.jitter.count()))};
      const Time due = std::max(on_the_way_.empty() ? now_ : on_the_way_.back().due, now_ + late);
      on_the_way_.push_back({due, std::move(bytes)});
    }
    while (!on_the_way_.empty() && on_the_way_.front().due <= now_) {
      bridge_.robot_says(on_the_way_.front().bytes, now_);
      on_the_way_.pop_front();
    }
  }
  void act(bridge::Bridge::Effects effects) {
    robot_.receive(effects.to_robot, now_);
    for (bridge::Frame& frame : effects.frames) {
      ++frames_;
      for (const std::size_t dead : conditions_.dead_sonars) {
        frame.sonar_range_m[dead] = std::numeric_limits<double>::quiet_NaN();
        frame.sonar_age_s[dead] = std::numeric_limits<double>::infinity();
      }
      const agent::Outputs outputs = agent_.step({.now = frame.stamp,
                                                  .sensors = {.sonar_range_m = frame.sonar_range_m,
                                                              .sonar_age_s = frame.sonar_age_s,
                                                              .p_WB = {frame.x_m, frame.y_m},
                                                              .yaw_WB_rad = frame.yaw_rad,
                                                              .left_wheel_rad = frame.left_wheel_rad,
                                                              .right_wheel_rad = frame.right_wheel_rad,
                                                              .holding = frame.holding},
                                                  .heard = {}});
      bridge_.wish({outputs.wheels.left_mps, outputs.wheels.right_mps, outputs.gripper_closed}, frame.stamp,
                   now_);
    }
  }

  struct Late {
    Time due;
    bridge::arcos::Bytes bytes;
  };
  Conditions conditions_;
  pure::Random random_;
  runtime::TomlDocument scenario_;
  world::World world_;
  agent::Agent agent_;
  bridge::Bridge bridge_{{}};
  bridge::Microcontroller robot_{{}};
  bridge::GpsReceiver gps_{{}};
  Time now_{0};
  std::vector<std::optional<world::Command>> commands_{std::nullopt};
  std::deque<Late> on_the_way_;
  std::size_t touched_ = 0;
  std::size_t frames_ = 0;
};

class HardwareTiming : public ::testing::TestWithParam<Conditions> {};

TEST_P(HardwareTiming, AnItemIsDelivered) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(seed);
    Hardware hardware{GetParam(), seed};
    while (!hardware.delivered() && hardware.now_s() < 900.0) hardware.step();
    EXPECT_TRUE(hardware.delivered());
    std::cout << GetParam().name << " seed " << seed << ": " << hardware.now_s() << " s, "
              << hardware.frames() << " frames, " << hardware.contacts() << " contacts\n";
  }
}

std::string name_of(const ::testing::TestParamInfo<Conditions>& conditions) { return conditions.param.name; }

INSTANTIATE_TEST_SUITE_P(Conditions, HardwareTiming,
                         ::testing::Values(Conditions{"TenFramesASecond", 0ms, 0.0, {}},
                                           Conditions{"LateByUpTo150Milliseconds", 150ms, 0.0, {}},
                                           Conditions{"EveryThirdLost", 0ms, 0.33, {}},
                                           Conditions{"ThreeSonarsDead", 0ms, 0.0, {2, 5, 9}},
                                           Conditions{"LateLostAndPartlyDeaf", 80ms, 0.15, {4}}),
                         name_of);

}  // namespace
}  // namespace caravan
