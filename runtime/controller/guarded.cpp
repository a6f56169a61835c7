// SPDX-License-Identifier: Apache-2.0
#include "runtime/controller/guarded.hpp"

#include <algorithm>
#include <cstdio>

#include "runtime/controller/crash_line.hpp"
#include "runtime/controller/floating_point.hpp"
#include "runtime/controller/outputs_check.hpp"
#include "runtime/controller/thrown.hpp"
#include "runtime/pure/one_line.hpp"

namespace caravan::runtime {
namespace {

/// Without NUL, which no detail may have.
bool is_control(char one) {
  const auto byte = static_cast<unsigned char>(one);
  return (byte > 0 && byte < 0x20) || byte == 0x7f;
}

/// Of any length, unlike one_line().
std::string escaped(const std::string& text) {
  std::string all;
  for (const char one : text) all += is_control(one) ? pure::one_line({&one, 1}) : std::string{one};
  return all;
}

void escape_details(Report& report) {
  for (Event& event : report.events) {
    if (std::ranges::any_of(event.detail, is_control)) event.detail = escaped(event.detail);
  }
}

}  // namespace

std::string GuardedController::where() const {
  char text[64];
  std::snprintf(text, sizeof text, "%.3f s", std::chrono::duration<double>(now_).count());
  return who_ + ", step " + std::to_string(steps_) + " (" + text + ")";
}

void GuardedController::look_at_radio(const Outputs& outputs) {
  warnings_ = radio_.look(outputs);
  for (std::string& warning : warnings_) warning.insert(0, where() + ": ");
}

Outputs GuardedController::step(const Inputs& inputs) {
  ++steps_;
  now_ = inputs.now;
  if (trace_) trace_->ask(inputs);
  Outputs outputs = call(inputs);
  if (outputs.report) escape_details(*outputs.report);  // makes them longer
  if (const std::string fault = fault_in(outputs, now_); !fault.empty())
    throw ControllerFault{where() + ": " + fault};
  look_at_radio(outputs);
  if (trace_) trace_->answer(outputs);
  return outputs;
}

Outputs GuardedController::call(const Inputs& inputs) {
  const InsideController inside{who_.c_str(), steps_, now_};
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
