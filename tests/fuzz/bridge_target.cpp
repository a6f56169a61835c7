// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "hardware_bridge/core/host/bridge.hpp"
#include "hardware_bridge/core/nmea/sentence.hpp"
#include "hardware_bridge/core/robot/microcontroller.hpp"
#include "runtime/pure/assert.hpp"
#include "tests/fuzz/bridge_targets.hpp"

namespace caravan::bridge::fuzz {
namespace {

using namespace std::chrono_literals;

class Script {
 public:
  explicit Script(std::span<const std::uint8_t> bytes) : bytes_{bytes} {}
  [[nodiscard]] bool is_over() const { return bytes_.empty(); }
  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t value = bytes_[0];
    bytes_ = bytes_.subspan(1);
    return value;
  }
  std::span<const std::uint8_t> take(std::size_t wanted) {
    const auto taken = bytes_.first(std::min(wanted, bytes_.size()));
    bytes_ = bytes_.subspan(taken.size());
    return taken;
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

}  // namespace

void bridge(std::span<const std::uint8_t> bytes) {
  Script script{bytes};
  Bridge bridge{{}};
  Microcontroller robot{{}};
  Time now{0};
  Time last_stamp{-1};
  robot.connected(now);
  bridge.robot_up(now);
  while (!script.is_over()) {
    now += 10ms;
    const std::uint8_t what = script.byte();
    const auto stuff = script.take(what >> 3U);
    // The lower bits of the first byte: garbage to the host, to the robot, from the GPS. Otherwise host and
    // robot exchange their own bytes.
    if ((what & 1U) != 0) bridge.robot_says(stuff, now);
    if ((what & 2U) != 0) robot.receive(stuff, now);
    if ((what & 4U) != 0) bridge.gps_says(stuff, now);
    robot.sense({}, now);
    bridge.robot_says(robot.take_output(), now);
    bridge.wish({0.5, 0.5, (what & 1U) != 0}, std::max(last_stamp, Time{0}), now);
    bridge.tick(now);
    CARAVAN_ASSERT(bridge.next_deadline(now) >= Time{0});
    const Bridge::Effects effects = bridge.take_effects();
    robot.receive(effects.to_robot, now);
    if (effects.reopen_robot) {
      robot.connected(now);
      bridge.robot_up(now);
    }
    const BodyDrive drive = robot.drive(now);
    CARAVAN_ASSERT(std::abs(drive.left_mps) <= 4.5 && std::abs(drive.right_mps) <= 4.5);
    for (const Frame& frame : effects.frames) {
      CARAVAN_ASSERT(frame.stamp > last_stamp);
      last_stamp = frame.stamp;
      CARAVAN_ASSERT(std::isfinite(frame.left_wheel_rad) && std::isfinite(frame.right_wheel_rad));
      for (const double range : frame.sonar_range_m) CARAVAN_ASSERT(std::isnan(range) || range >= 0.0);
    }
  }
}

void nmea(std::span<const std::uint8_t> bytes) {
  nmea::SentenceFinder finder;
  for (const std::string& sentence : finder.feed(bytes)) {
    CARAVAN_ASSERT(sentence.size() <= nmea::kLongest);
    const auto parsed = nmea::parse(sentence);
    if (!parsed) continue;
    const auto* gga = std::get_if<nmea::Gga>(&*parsed);
    if (gga == nullptr) continue;
    CARAVAN_ASSERT(std::abs(gga->latitude_deg) <= 90.0 && std::abs(gga->longitude_deg) <= 180.0);
    const std::string line = nmea::to_line(*gga);
    nmea::SentenceFinder second;
    const auto again = second.feed({reinterpret_cast<const std::uint8_t*>(line.data()), line.size()});
    CARAVAN_ASSERT(again.size() == 1 && nmea::parse(again[0]).has_value());
  }
}

}  // namespace caravan::bridge::fuzz
