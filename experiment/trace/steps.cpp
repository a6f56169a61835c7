// SPDX-License-Identifier: Apache-2.0
#include "experiment/trace/steps.hpp"

#include <bit>
#include <stdexcept>
#include <utility>

namespace caravan::experiment {
namespace {

/// Reads values from the front of a step.
class Source {
 public:
  explicit Source(std::span<const std::uint8_t> bytes) : left_{bytes} {}

  std::uint64_t word() {
    const auto eight = take(8);
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < 8; ++i) number |= std::uint64_t{eight[i]} << (8 * i);
    return number;
  }
  double real() { return std::bit_cast<double>(word()); }
  std::vector<std::uint8_t> bytes() {
    const auto string = take(word());
    return {string.begin(), string.end()};
  }
  void end() const {
    if (!left_.empty()) throw std::runtime_error{"a step has too many bytes"};
  }

 private:
  std::span<const std::uint8_t> take(std::uint64_t count) {
    if (count > left_.size()) throw std::runtime_error{"a step has too few bytes"};
    const auto front = left_.first(count);
    left_ = left_.subspan(count);
    return front;
  }

  std::span<const std::uint8_t> left_;
};

std::vector<TracedFrame> read_frames(Source& source) {
  std::vector<TracedFrame> frames;
  for (std::uint64_t left = source.word(); left > 0; --left) {
    const std::uint64_t channel = source.word();
    frames.push_back({channel, source.bytes()});
  }
  return frames;
}

std::vector<TracedPose> read_poses(Source& source, std::uint32_t robots) {
  std::vector<TracedPose> poses(robots);
  for (TracedPose& pose : poses) {
    pose.x_m = source.real();
    pose.y_m = source.real();
    pose.yaw_rad = source.real();
  }
  return poses;
}

}  // namespace

WorldStep read_world_step(std::span<const std::uint8_t> bytes, std::uint32_t robots) {
  Source source{bytes};
  WorldStep step;
  const std::size_t step_size = 8 + std::size_t{56} * robots;
  const std::size_t placement_size = 8 + std::size_t{24} * robots;
  for (std::size_t left = bytes.size(); left >= step_size + placement_size; left -= placement_size) {
    const std::uint64_t robot = source.word();
    step.placements.push_back({robot, read_poses(source, robots)});
  }
  step.number = source.word();
  for (std::uint32_t robot = 1; robot <= robots; ++robot) {
    TracedCommand command;
    command.given = source.word() != 0;
    command.left_mps = source.real();
    command.right_mps = source.real();
    command.gripper_closed = source.word() != 0;
    step.commands.push_back(command);
  }
  step.poses = read_poses(source, robots);
  source.end();
  return step;
}

RadioStep read_radio_step(std::span<const std::uint8_t> bytes) {
  Source source{bytes};
  RadioStep step;
  step.stamp_ns = source.word();
  for (std::uint64_t left = source.word(); left > 0; --left) {
    const std::uint64_t robot = source.word();
    const std::uint64_t tuned = source.word();
    step.sent[robot] = {tuned, read_frames(source)};
  }
  for (std::uint64_t left = source.word(); left > 0; --left) {
    const std::uint64_t robot = source.word();
    step.heard[robot] = read_frames(source);
  }
  source.end();
  return step;
}

caravan::Inputs read_inputs(std::span<const std::uint8_t> bytes) {
  Source source{bytes};
  caravan::Inputs inputs;
  inputs.now = caravan::Time{static_cast<std::int64_t>(source.word())};
  for (double& range_m : inputs.sensors.sonar_range_m) range_m = source.real();
  for (double& age_s : inputs.sensors.sonar_age_s) age_s = source.real();
  for (double* number : {&inputs.sensors.position.x_m, &inputs.sensors.position.y_m, &inputs.sensors.yaw_rad,
                         &inputs.sensors.left_wheel_rad, &inputs.sensors.right_wheel_rad})
    *number = source.real();
  inputs.sensors.holding = source.word() != 0;
  for (std::uint64_t left = source.word(); left > 0; --left) {
    const auto channel = static_cast<std::uint32_t>(source.word());
    std::vector<std::uint8_t> frame = source.bytes();
    inputs.heard.push_back({channel, std::move(frame), source.real()});
  }
  source.end();
  return inputs;
}

caravan::Outputs read_outputs(std::span<const std::uint8_t> bytes) {
  Source source{bytes};
  caravan::Outputs outputs;
  outputs.left_mps = source.real();
  outputs.right_mps = source.real();
  outputs.gripper_closed = source.word() != 0;
  outputs.tuned_channel = static_cast<std::uint32_t>(source.word());
  for (std::uint64_t left = source.word(); left > 0; --left) {
    const auto channel = static_cast<std::uint32_t>(source.word());
    outputs.frames.push_back({channel, source.bytes()});
  }
  source.end();
  return outputs;
}

}  // namespace caravan::experiment
