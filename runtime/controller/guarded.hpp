// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/controller.hpp>
#include <memory>
#include <stdexcept>
#include <string>

#include "runtime/controller/step_trace.hpp"
#include "runtime/pure/one_line.hpp"

namespace caravan::runtime {

/// A controller has broken the rules of the interface. The message names it, its robot and the step.
struct ControllerFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A robot's controller, with faults made into one kind of exception, and its steps recorded if wanted.
class GuardedController {
 public:
  /// @param trace  null: none
  GuardedController(std::unique_ptr<Controller> controller, const std::string& name, std::uint32_t robot,
                    std::unique_ptr<StepTrace> trace = nullptr)
      : controller_{std::move(controller)},
        who_{"controller " + pure::one_line(name) + ", robot " + std::to_string(robot)},
        trace_{std::move(trace)} {}

  /// @throws ControllerFault when the controller throws, or its outputs exceed the limits of the interface
  /// @throws WriteError when the trace cannot be written
  [[nodiscard]] Outputs step(const Inputs& inputs);

  /// "controller mine, robot 3, step 1234 (39.488 s)": of the last step begun.
  [[nodiscard]] std::string where() const;

 private:
  [[nodiscard]] Outputs call(const Inputs& inputs);

  std::unique_ptr<Controller> controller_;
  std::string who_;
  std::unique_ptr<StepTrace> trace_;
  std::uint64_t steps_ = 0;  // begun
  Time now_{0};
};

}  // namespace caravan::runtime
