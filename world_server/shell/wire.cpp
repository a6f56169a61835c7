// SPDX-License-Identifier: Apache-2.0
#include "world_server/shell/wire.hpp"

namespace caravan::world {
namespace msg = caravan_interfaces::msg;

void to_wire(const Sensors& sensors, msg::SensorFrame& frame) {
  frame.sonar_range_m(sensors.sonar_range_m);
  frame.sonar_age_s(sensors.sonar_age_s);
  frame.gps_x_m(sensors.position.x_m);
  frame.gps_y_m(sensors.position.y_m);
  frame.compass_yaw_rad(sensors.yaw_rad);
  frame.left_wheel_rad(sensors.left_wheel_rad);
  frame.right_wheel_rad(sensors.right_wheel_rad);
  frame.holding(sensors.holding);
}

void to_wire(const World& world, std::span<const std::uint32_t> members, msg::WorldTruth& truth) {
  truth.members().assign(members.begin(), members.end());
  const auto poses = world.poses();
  truth.robots().clear();
  for (std::uint32_t number = 1; number <= poses.size(); ++number) {
    if (!world.is_present(number)) continue;
    const Pose& pose = poses[number - 1];
    msg::RobotTruth robot;
    robot.robot(number);
    robot.x_m(pose.x_m);
    robot.y_m(pose.y_m);
    robot.yaw_rad(pose.yaw_rad);
    truth.robots().push_back(robot);
  }
  truth.contacts().clear();
  for (const ContactEpisode& contact : world.contacts()) {
    msg::ContactEpisode episode;
    episode.robot(contact.robot);
    episode.other(contact.other);
    truth.contacts().push_back(episode);
  }
  truth.item_events().clear();
  for (const ItemEvent& event : world.item_events()) {
    msg::ItemEvent item;
    item.kind(event.kind == ItemEvent::Kind::kDelivery ? msg::ItemEvent_Constants::DELIVERY
                                                       : msg::ItemEvent_Constants::PICK_UP);
    item.robot(event.robot);
    truth.item_events().push_back(item);
  }
  truth.items_delivered(world.items_delivered());
}

}  // namespace caravan::world
