// SPDX-License-Identifier: Apache-2.0
#include "tests/rogue/forger.hpp"

#include <array>
#include <limits>

namespace caravan::test {
namespace msg = caravan_interfaces::msg;
using namespace std::chrono_literals;

std::chrono::nanoseconds Forger::stamp() {
  switch (below(6)) {
    case 0:
      return known_.stamp;
    case 1:
      return known_.next_stamp;
    case 2:
      return known_.stamp + 1h;
    case 3:
      return std::chrono::seconds{std::numeric_limits<std::int32_t>::max()};
    case 4:
      return -1s;
    default:
      return std::chrono::milliseconds{32 * below(100'000)};
  }
}

std::uint64_t Forger::session() {
  switch (below(4)) {
    case 0:
    case 1:
      return known_.session;
    case 2:
      return known_.session + 1 + below(1000);
    default:
      return std::numeric_limits<std::uint64_t>::max();
  }
}

double Forger::real() {
  constexpr std::array kReals{0.0, -1.0, 1e308, std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity()};
  const std::uint32_t which = below(2 * kReals.size());
  return which < kReals.size() ? kReals.at(which) : 0.001 * below(10'000) - 5.0;
}

Bytes Forger::payload() {
  Bytes bytes(below(300));
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random_());
  // A frame that looks like one of the robots' own protocol.
  if (bytes.size() > 1) bytes[0] = 0xc1, bytes[1] = static_cast<std::uint8_t>(1 + below(7));
  return bytes;
}

void Forger::forge(msg::SensorFrame& frame) {
  date(frame);
  for (double& range_m : frame.sonar_range_m()) range_m = real();
  frame.gps_x_m(real());
  frame.gps_y_m(real());
  frame.compass_yaw_rad(real());
  frame.holding(below(2) == 0);
  frame.radio_due(below(2) == 0);
}

void Forger::forge(msg::RobotCommand& command) {
  date(command);
  command.left_mps(real());
  command.right_mps(real());
  command.gripper_closed(below(2) == 0);
  command.reported(below(2) == 0);
}

void Forger::forge(msg::RadioTransmit& transmit) {
  date(transmit);
  transmit.tuned_channel(below(4));
  transmit.frames().resize(below(100));
  for (msg::RadioFrame& frame : transmit.frames()) {
    frame.channel(below(3));
    frame.bytes(payload());
  }
}

void Forger::forge(msg::RadioReceive& receive) {
  date(receive);
  receive.frames().resize(1 + below(100));
  for (msg::ReceivedFrame& frame : receive.frames()) {
    frame.channel(below(3));
    frame.bytes(payload());
    frame.signal_strength_dbm(real());
  }
}

void Forger::forge(msg::Telemetry& telemetry) {
  date(telemetry);
  telemetry.mode(static_cast<std::uint8_t>(below(4)));
  telemetry.activity(static_cast<std::uint8_t>(below(6)));
  telemetry.trips(below(1000));
  telemetry.path_changed(true);
  telemetry.path().resize(below(2000));
  telemetry.exchanges().resize(below(20));
  telemetry.events().resize(below(20));
  for (msg::AgentEvent& event : telemetry.events()) event.detail(std::string(below(5000), '\x1b'));
}

void Forger::forge(msg::WorldTruth& truth) {
  date(truth);
  truth.next_stamp(idl::to_wire(stamp()));
  truth.last(below(2) == 0);
  truth.robots().resize(below(100));
  for (msg::RobotTruth& robot : truth.robots()) {
    robot.robot(below(robots_ + 2));
    robot.x_m(real());
    robot.y_m(real());
    truth.members().push_back(below(robots_ + 2));
    truth.reported().push_back(below(robots_ + 2));
  }
  truth.items_delivered(below(1000));
}

void Forger::forge(msg::RadioStep& step) {
  date(step);
  step.receivers().resize(below(1000), below(robots_ + 2));
  step.chain(random_());
  step.controlled(below(2) == 0);
}

void Forger::forge(msg::WorldStatus& status) {
  date(status);
  status.state(static_cast<std::uint8_t>(below(4)));
  status.missing().resize(below(100), "robot 1");
  status.completed(below(2) == 0);
  status.disturbed(below(2) == 0);
  status.paused(below(2) == 0);
  status.held(below(2) == 0 ? "" : "a rogue");
  status.digest("0123456789abcdef");
}

void Forger::forge(msg::RadioStatus& status) {
  date(status);
  status.awaited().resize(below(100), "robot 1");
}

void Forger::forge(msg::RunCredit& credit) {
  credit.observer(below(2) == 0 ? "launcher" : "observer " + std::to_string(below(1000)));
  date(credit);
}

void Forger::forge(msg::ControlRequest& request) {
  request.requester("rogue " + std::to_string(below(1000)));
  request.id(below(1'000'000));
  request.session(session());
  request.action(static_cast<std::uint8_t>(below(20)));
  request.at_step(below(2) == 0 ? 0 : random_());
  request.steps(below(1'000'000));
  request.robots().resize(below(100), below(robots_ + 2));
  request.speed_factor(real());
  request.x_m(real());
  request.loss_probability(real());
}

void Forger::forge(msg::ControlReply& reply) {
  reply.requester("rogue");
  reply.session(session());
}

void Forger::spoil(Bytes& bytes) {
  constexpr std::array<std::uint8_t, 4> kBytes{2, 0x7f, 0xff, 0};
  if (bytes.size() < 8) return;
  for (std::uint32_t left = 1 + below(4); left > 0; --left) {
    const std::size_t place = 4 + below(static_cast<std::uint32_t>(bytes.size() - 4));
    if (below(2) == 0) {
      bytes[place] = kBytes.at(below(kBytes.size()));
      continue;
    }
    // Probably a length: lengths in CDR are aligned to four bytes.
    const std::size_t word = place / 4 * 4;
    for (std::size_t i = word; i < std::min(word + 4, bytes.size()); ++i)
      bytes[i] = i < word + 3 ? 0xff : 0x7f;
  }
  if (below(8) == 0) bytes.resize(4 + below(static_cast<std::uint32_t>(bytes.size())));
}

Bytes Forger::noise() {
  // Rarely much longer than any of our samples.
  Bytes bytes(below(200) == 0 ? 3U << 20U : below(2000));
  if (bytes.size() < 3000) {
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random_());
  }
  if (bytes.size() >= 4 && below(2) == 0) bytes[0] = 0, bytes[1] = static_cast<std::uint8_t>(below(8));
  return bytes;
}

}  // namespace caravan::test
