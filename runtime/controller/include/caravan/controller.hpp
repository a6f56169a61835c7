// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include <caravan/parameters.hpp>
#include <caravan/robot.hpp>
#include <caravan/types.hpp>

namespace caravan {

/// What drives one robot: a function of what it has been given so far.
///
/// A controller gets no clock, no other robot's memory and no truth. Equal inputs must give equal outputs:
/// then a run can be repeated bit for bit, in one process or in many. So a controller keeps its state in its
/// members, not in globals, takes the time from Inputs::now and its random numbers from Robot::random().
class Controller {
 public:
  Controller() = default;
  virtual ~Controller() = default;
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;

  /// One step, every 32 ms unless the scenario says otherwise. Time does not go back.
  ///
  /// Wheel speeds that are not finite, a report beyond the limits in types.hpp, and an exception end the
  /// controller of this robot: the program says so by name, robot and step. A step that does not return
  /// within 10 s is ended as well. Control characters in the detail of an event are escaped. What a call
  /// changes in the floating-point environment (rounding, traps, flushing to zero) is undone when it returns.
  [[nodiscard]] virtual Outputs step(const Inputs& inputs) = 0;
};

/// Raised when a type in these headers, or the meaning of a value, changes.
inline constexpr std::uint32_t kControllerInterface = 1;

/// What a controller library exports.
struct ControllerLibrary {
  std::uint32_t interface = kControllerInterface;  ///< stays the first member in all versions
  const char* name = "";  ///< in messages and results: lower_snake_case, 1 to 64 characters
  /// A controller for one robot, never null. @throws ParameterError and whatever its constructor throws
  std::unique_ptr<Controller> (*make)(const Robot& robot, Parameters& parameters) = nullptr;
};

}  // namespace caravan

/// Exports a controller from a shared library: once in a library, outside of all namespaces.
///
/// @param Class  a caravan::Controller with a constructor (const caravan::Robot&, caravan::Parameters&)
/// @param Name   a string literal: lower_snake_case, 1 to 64 characters
#define CARAVAN_CONTROLLER(Class, Name)                                                                      \
  extern "C" __attribute__((visibility("default"))) const caravan::ControllerLibrary* caravan_controller() { \
    static constexpr caravan::ControllerLibrary library{                                                     \
        .name = Name, .make = [](const caravan::Robot& robot, caravan::Parameters& parameters) {             \
          return std::unique_ptr<caravan::Controller>{new Class{robot, parameters}};                         \
        }};                                                                                                  \
    return &library;                                                                                         \
  }
