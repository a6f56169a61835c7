// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/types.hpp>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

/// One step of a run; docs/digest.md defines its bytes.
namespace caravan::experiment {

struct TracedCommand {
  bool given = false;  ///< false: none was given, the wheels were stopped
  double left_mps = 0.0;
  double right_mps = 0.0;
  bool gripper_closed = false;
};

struct TracedPose {
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;
};

struct TracedFrame {
  std::uint64_t channel = 0;
  std::vector<std::uint8_t> bytes;
  bool operator==(const TracedFrame&) const = default;
};

/// A robot that was moved, removed or added before the step.
struct TracedPlacement {
  std::uint64_t robot = 0;
  std::vector<TracedPose> poses;  ///< of all robots after it
};

struct WorldStep {
  std::vector<TracedPlacement> placements;
  std::uint64_t number = 0;             ///< from 1
  std::vector<TracedCommand> commands;  ///< [0] is robot 1
  std::vector<TracedPose> poses;        ///< after the step
};

struct TracedTransmission {
  std::uint64_t tuned = 0;
  std::vector<TracedFrame> frames;
};

struct RadioStep {
  std::uint64_t stamp_ns = 0;                               ///< at which it began
  std::map<std::uint64_t, TracedTransmission> sent;         ///< by robot
  std::map<std::uint64_t, std::vector<TracedFrame>> heard;  ///< by robot
};

/// @throws std::runtime_error when the bytes are not exactly one step of `robots` robots
[[nodiscard]] WorldStep read_world_step(std::span<const std::uint8_t> bytes, std::uint32_t robots);
/// @throws std::runtime_error when the bytes are not exactly one step
[[nodiscard]] RadioStep read_radio_step(std::span<const std::uint8_t> bytes);
/// What a controller was given in a step, without Inputs::destination.
/// @throws std::runtime_error when the bytes are not exactly that
[[nodiscard]] caravan::Inputs read_inputs(std::span<const std::uint8_t> bytes);
/// What it answered, without Outputs::report.
/// @throws std::runtime_error when the bytes are not exactly that
[[nodiscard]] caravan::Outputs read_outputs(std::span<const std::uint8_t> bytes);

}  // namespace caravan::experiment
