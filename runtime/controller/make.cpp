// SPDX-License-Identifier: Apache-2.0
#include "runtime/controller/make.hpp"

namespace caravan::runtime {

std::unique_ptr<Controller> make_controller(const ControllerLibrary& library, const Robot& robot,
                                            TomlTable table) {
  Parameters parameters{table.rest()};
  std::unique_ptr<Controller> controller;
  try {
    controller = library.make(robot, parameters);
  } catch (const ParameterError& error) {
    table.fail(error.key(), error.what());
  } catch (const std::exception& error) {
    throw StartError{"controller " + std::string{library.name} + ", robot " + std::to_string(robot.id) +
                     ": cannot be made: " + error.what()};
  } catch (...) {
    throw StartError{"controller " + std::string{library.name} + ", robot " + std::to_string(robot.id) +
                     ": cannot be made: its constructor threw something that is no std::exception"};
  }
  for (const std::string& key : parameters.unknown()) table.fail(key, "unknown key");
  return controller;
}

}  // namespace caravan::runtime
