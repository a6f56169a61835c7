// SPDX-License-Identifier: Apache-2.0
#include "experiment/trace/step_text.hpp"

#include <algorithm>

#include "experiment/trace/text_of.hpp"

namespace caravan::experiment {
namespace {

template <std::size_t size>
std::string list_of(const std::array<double, size>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : " ") + text_of(value);
  return text;
}

std::string line(const std::string& name, const std::string& value) {
  constexpr std::size_t kWidth = 20;
  return "  " + name + std::string(kWidth - std::min(kWidth - 1, name.size()), ' ') + value + "\n";
}

std::string frame_line(const std::string& name, std::uint32_t channel, const std::vector<std::uint8_t>& bytes,
                       const std::string& more) {
  return line(name, "channel " + std::to_string(channel) + ", " + std::to_string(bytes.size()) + " bytes" +
                        more + ": " + text_of(bytes));
}

}  // namespace

std::string text_of(const caravan::Inputs& inputs) {
  const caravan::Sensors& sensors = inputs.sensors;
  std::string text = line("position_m", text_of(sensors.position.x_m) + " " + text_of(sensors.position.y_m));
  text += line("yaw_rad", text_of(sensors.yaw_rad));
  text += line("sonar_range_m", list_of(sensors.sonar_range_m));
  text += line("sonar_age_s", list_of(sensors.sonar_age_s));
  text += line("left_wheel_rad", text_of(sensors.left_wheel_rad));
  text += line("right_wheel_rad", text_of(sensors.right_wheel_rad));
  text += line("holding", text_of(sensors.holding));
  text += line("destination_m",
               inputs.destination ? text_of(inputs.destination->x_m) + " " + text_of(inputs.destination->y_m)
                                  : "not in sight");
  text += line("heard", std::to_string(inputs.heard.size()) + " frames");
  for (std::size_t i = 0; i < inputs.heard.size(); ++i) {
    const caravan::ReceivedFrame& frame = inputs.heard[i];
    text += frame_line("heard_" + std::to_string(i + 1), frame.channel, frame.bytes,
                       ", " + text_of(frame.signal_strength_dbm) + " dBm");
  }
  return text;
}

std::string text_of(const caravan::Outputs& outputs) {
  std::string text = line("left_mps", text_of(outputs.left_mps));
  text += line("right_mps", text_of(outputs.right_mps));
  text += line("gripper_closed", text_of(outputs.gripper_closed));
  text += line("tuned_channel", std::to_string(outputs.tuned_channel));
  text += line("frames", std::to_string(outputs.frames.size()));
  for (std::size_t i = 0; i < outputs.frames.size(); ++i)
    text +=
        frame_line("frame_" + std::to_string(i + 1), outputs.frames[i].channel, outputs.frames[i].bytes, "");
  return text;
}

}  // namespace caravan::experiment
