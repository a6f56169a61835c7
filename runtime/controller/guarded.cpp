// SPDX-License-Identifier: Apache-2.0
#include "runtime/controller/guarded.hpp"

#include <cmath>
#include <cstdio>

#include "runtime/pure/one_line.hpp"

namespace caravan::runtime {

std::string GuardedController::where() const {
  char text[64];
  std::snprintf(text, sizeof text, "%.3f s", std::chrono::duration<double>(now_).count());
  return "controller " + pure::one_line(name_) + ", robot " + std::to_string(robot_) + ", step " +
         std::to_string(steps_) + " (" + text + ")";
}

Outputs GuardedController::step(const Inputs& inputs) {
  ++steps_;
  now_ = inputs.now;
  if (trace_) trace_->ask(inputs);
  Outputs outputs;
  try {
    outputs = controller_->step(inputs);
  } catch (const std::exception& error) {
    throw ControllerFault{where() + ": threw an exception: " + pure::one_line(error.what())};
  } catch (...) {
    throw ControllerFault{where() + ": threw something that is no std::exception"};
  }
  if (!std::isfinite(outputs.left_mps) || !std::isfinite(outputs.right_mps))
    throw ControllerFault{where() + ": wheel speeds " + std::to_string(outputs.left_mps) + " and " +
                          std::to_string(outputs.right_mps) + " m/s are not finite"};
  if (trace_) trace_->answer(outputs);
  return outputs;
}

}  // namespace caravan::runtime
