// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/controller.hpp>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "runtime/controller/radio_watch.hpp"
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
                    RadioWatch radio, std::unique_ptr<StepTrace> trace)
      : controller_{std::move(controller)},
        who_{"controller " + pure::one_line(name) + ", robot " + std::to_string(robot)},
        radio_{std::move(radio)},
        trace_{std::move(trace)} {}

  /// Control characters in the details of events are escaped in the result.
  ///
  /// @throws ControllerFault when the controller throws, or its outputs exceed the limits of the interface
  /// @throws WriteError when the trace cannot be written
  [[nodiscard]] Outputs step(const Inputs& inputs);

  /// Lines about what the radio drops of the last step's outputs; each kind once in a process.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

  /// "controller mine, robot 3, step 1234 (39.488 s)": of the last step begun.
  [[nodiscard]] std::string where() const;

 private:
  void look_at_radio(const Outputs& outputs);
  [[nodiscard]] Outputs call(const Inputs& inputs);

  std::unique_ptr<Controller> controller_;
  std::string who_;
  RadioWatch radio_;
  std::vector<std::string> warnings_;
  std::unique_ptr<StepTrace> trace_;
  std::uint64_t steps_ = 0;  // begun
  Time now_{0};
};

}  // namespace caravan::runtime
