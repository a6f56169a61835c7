// SPDX-License-Identifier: Apache-2.0
#include "runtime/controller/step_trace.hpp"

#include <bit>

namespace caravan::runtime {
namespace {

/// All bits as they are, also of -0: a controller may tell it from +0.
void append(pure::CanonicalBytes& bytes, double number) { bytes.word(std::bit_cast<std::uint64_t>(number)); }

}  // namespace

StepTrace::StepTrace(const std::filesystem::path& folder, std::uint32_t robot)
    : file_{robot_trace_in(folder, robot), kRobotTrace, robot} {}

void StepTrace::ask(const Inputs& inputs) {
  const Sensors& sensors = inputs.sensors;
  bytes_.clear();
  bytes_.word(static_cast<std::uint64_t>(inputs.now.count()));
  for (const double range_m : sensors.sonar_range_m) append(bytes_, range_m);
  for (const double age_s : sensors.sonar_age_s) append(bytes_, age_s);
  append(bytes_, sensors.position.x_m);
  append(bytes_, sensors.position.y_m);
  append(bytes_, sensors.yaw_rad);
  append(bytes_, sensors.left_wheel_rad);
  append(bytes_, sensors.right_wheel_rad);
  bytes_.word(sensors.holding ? 1 : 0);
  bytes_.word(inputs.heard.size());
  for (const ReceivedFrame& frame : inputs.heard) {
    bytes_.word(frame.channel);
    bytes_.bytes(frame.bytes);
    append(bytes_, frame.signal_strength_dbm);
  }
  record();
}

void StepTrace::answer(const Outputs& outputs) {
  bytes_.clear();
  append(bytes_, outputs.left_mps);
  append(bytes_, outputs.right_mps);
  bytes_.word(outputs.gripper_closed ? 1 : 0);
  bytes_.word(outputs.tuned_channel);
  bytes_.word(outputs.frames.size());
  for (const Frame& frame : outputs.frames) {
    bytes_.word(frame.channel);
    bytes_.bytes(frame.bytes);
  }
  record();
}

void StepTrace::record() {
  file_.record(bytes_.view());
  file_.flush();
}

}  // namespace caravan::runtime
