// SPDX-License-Identifier: Apache-2.0
#include "runtime/controller/guarded.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "runtime/controller/crash_line.hpp"
#include "runtime/pure/one_line.hpp"

namespace caravan::runtime {
namespace {

bool is_lower_snake_case(const std::string& name) {
  const auto is_letter = [](char one) { return one >= 'a' && one <= 'z'; };
  return !name.empty() && is_letter(name.front()) && std::ranges::all_of(name, [&](char one) {
    return is_letter(one) || (one >= '0' && one <= '9') || one == '_';
  });
}

bool is_control(char one) {
  const auto byte = static_cast<unsigned char>(one);
  return byte < 0x20 || byte == 0x7f;
}

/// Of any length, unlike one_line().
std::string escaped(const std::string& text) {
  std::string all;
  for (const char one : text) all += is_control(one) ? pure::one_line({&one, 1}) : std::string{one};
  return all;
}

}  // namespace

std::string GuardedController::where() const {
  char text[64];
  std::snprintf(text, sizeof text, "%.3f s", std::chrono::duration<double>(now_).count());
  return who_ + ", step " + std::to_string(steps_) + " (" + text + ")";
}

void GuardedController::check_report(Report& report) const {
  for (Event& event : report.events) {
    if (!is_lower_snake_case(event.name))
      throw ControllerFault{where() + ": the name of an event, \"" + pure::one_line(event.name) +
                            "\", is not in lower_snake_case"};
    if (std::ranges::any_of(event.detail, is_control)) event.detail = escaped(event.detail);
  }
}

void GuardedController::look_at_radio(const Outputs& outputs) {
  warnings_ = radio_.look(outputs);
  for (std::string& warning : warnings_) warning.insert(0, where() + ": ");
}

Outputs GuardedController::step(const Inputs& inputs) {
  ++steps_;
  now_ = inputs.now;
  if (trace_) trace_->ask(inputs);
  Outputs outputs;
  const InsideController inside{who_.c_str(), steps_, now_};
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
  if (outputs.report) check_report(*outputs.report);
  look_at_radio(outputs);
  if (trace_) trace_->answer(outputs);
  return outputs;
}

}  // namespace caravan::runtime
