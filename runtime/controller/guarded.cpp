// SPDX-License-Identifier: Apache-2.0
#include "runtime/controller/guarded.hpp"

#include <cstdio>

#include "runtime/controller/crash_line.hpp"
#include "runtime/controller/floating_point.hpp"
#include "runtime/controller/outputs_check.hpp"
#include "runtime/controller/thrown.hpp"

namespace caravan::runtime {

std::string GuardedController::where() const {
  char text[64];
  std::snprintf(text, sizeof text, "%.3f s", std::chrono::duration<double>(now_).count());
  return who_ + ", step " + std::to_string(steps_) + " (" + text + ")";
}

Outputs GuardedController::step(const Inputs& inputs) {
  ++steps_;
  now_ = inputs.now;
  if (trace_) trace_->ask(inputs);
  Outputs outputs = call(inputs);
  if (const std::string fault = fault_in(outputs, now_); !fault.empty())
    throw ControllerFault{where() + ": " + fault};
  if (trace_) trace_->answer(outputs);
  return outputs;
}

Outputs GuardedController::call(const Inputs& inputs) {
  const InsideController inside{who_.c_str(), steps_};
  try {
    const KeptFloatingPoint kept;
    return controller_->step(inputs);
  } catch (const std::exception& error) {
    throw ControllerFault{where() + ": threw an exception: " + text_of(error)};
  } catch (...) {
    throw ControllerFault{where() + ": threw something that is no std::exception"};
  }
}

}  // namespace caravan::runtime
