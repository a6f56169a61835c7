// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/shell/wire.hpp"

namespace caravan::agent {
namespace msg = caravan_interfaces::msg;
namespace {

double seconds(Time time) { return std::chrono::duration<double>(time).count(); }

msg::ExchangeReport to_wire(const caravan::Exchange& exchange) {
  msg::ExchangeReport report;
  report.partner(exchange.partner);
  report.exchange_number(exchange.session);
  report.primary(exchange.primary);
  report.completed(exchange.completed);
  report.began_s(seconds(exchange.began));
  report.ended_s(seconds(exchange.ended));
  return report;
}

}  // namespace

caravan::Sensors to_sensors(const msg::SensorFrame& frame) {
  caravan::Sensors sensors;
  sensors.sonar_range_m = frame.sonar_range_m();
  sensors.sonar_age_s = frame.sonar_age_s();
  sensors.position = {frame.gps_x_m(), frame.gps_y_m()};
  sensors.yaw_rad = frame.compass_yaw_rad();
  sensors.left_wheel_rad = frame.left_wheel_rad();
  sensors.right_wheel_rad = frame.right_wheel_rad();
  sensors.holding = frame.holding();
  return sensors;
}

msg::RobotCommand to_command(const caravan::Outputs& outputs) {
  msg::RobotCommand command;
  command.left_mps(outputs.left_mps);
  command.right_mps(outputs.right_mps);
  command.gripper_closed(outputs.gripper_closed);
  return command;
}

msg::RadioTransmit to_transmit(caravan::Outputs& outputs) {
  msg::RadioTransmit transmit;
  transmit.tuned_channel(outputs.tuned_channel);
  transmit.frames().resize(outputs.frames.size());
  for (std::size_t i = 0; i < outputs.frames.size(); ++i) {
    transmit.frames()[i].channel(outputs.frames[i].channel);
    transmit.frames()[i].bytes(std::move(outputs.frames[i].bytes));
  }
  return transmit;
}

msg::Telemetry to_telemetry(const caravan::Report& report) {
  msg::Telemetry telemetry;
  // The enumerators of a report equal the constants of the IDL.
  static_assert(static_cast<int>(caravan::Mode::kTransport) == msg::Telemetry_Constants::MODE_TRANSPORT);
  static_assert(static_cast<int>(caravan::Activity::kExchanging) ==
                msg::Telemetry_Constants::ACTIVITY_EXCHANGING);
  static_assert(static_cast<int>(caravan::Activity::kAvoiding) ==
                msg::Telemetry_Constants::ACTIVITY_AVOIDING);
  static_assert(static_cast<int>(caravan::Origin::kReceived) == msg::Telemetry_Constants::ORIGIN_RECEIVED);
  telemetry.mode(static_cast<std::uint8_t>(report.mode));
  telemetry.activity(static_cast<std::uint8_t>(report.activity));
  telemetry.origin(static_cast<std::uint8_t>(report.origin));
  telemetry.towards_destination(report.towards_destination);
  telemetry.trips(report.trips);
  telemetry.malformed_frames(report.malformed_frames);
  telemetry.path_changed(report.path.has_value());
  for (const Position& point : report.path.value_or(std::vector<Position>{})) {
    msg::PathPoint vertex;
    vertex.x_m(point.x_m);
    vertex.y_m(point.y_m);
    telemetry.path().push_back(vertex);
  }
  for (const caravan::Exchange& exchange : report.exchanges)
    telemetry.exchanges().push_back(to_wire(exchange));
  for (const caravan::Event& event : report.events) {
    msg::AgentEvent told;
    told.name(event.name);
    told.detail(event.detail);
    telemetry.events().push_back(told);
  }
  return telemetry;
}

}  // namespace caravan::agent
