// SPDX-License-Identifier: Apache-2.0
#include "runtime/controller/make.hpp"

namespace caravan::runtime {

std::unique_ptr<Controller> make_controller(const LoadedController& loaded, const Robot& robot,
                                            TomlTable table) {
  auto values = table.rest();
  values.insert_or_assign("library", loaded.file.string());
  Parameters parameters{std::move(values)};
  (void)parameters.text("library", "");
  std::unique_ptr<Controller> controller;
  try {
    controller = loaded.library->make(robot, parameters);
  } catch (const ParameterError& error) {
    table.fail(error.key(), error.what());
  } catch (const std::exception& error) {
    throw StartError{"controller " + loaded.name + ", robot " + std::to_string(robot.id) +
                     ": cannot be made: " + error.what()};
  } catch (...) {
    throw StartError{"controller " + loaded.name + ", robot " + std::to_string(robot.id) +
                     ": cannot be made: its constructor threw something that is no std::exception"};
  }
  for (const std::string& key : parameters.unknown()) table.fail(key, "unknown key");
  return controller;
}

}  // namespace caravan::runtime
