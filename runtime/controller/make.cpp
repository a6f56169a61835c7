// SPDX-License-Identifier: Apache-2.0
#include "runtime/controller/make.hpp"

#include "runtime/controller/crash_line.hpp"
#include "runtime/controller/floating_point.hpp"
#include "runtime/controller/thrown.hpp"
#include "runtime/pure/one_line.hpp"

namespace caravan::runtime {

namespace {

/// The keys that the controller asked for; `library` is read for it.
std::string keys_of(const std::string& name, const Parameters& parameters) {
  std::string keys;
  for (const std::string& key : parameters.known()) {
    if (key != "library") keys += (keys.empty() ? "" : ", ") + key;
  }
  return "controller " + pure::one_line(name) + (keys.empty() ? " has no keys" : " has: " + keys);
}

}  // namespace

std::unique_ptr<Controller> make_controller(const LoadedController& loaded, const Robot& robot,
                                            TomlTable table) {
  auto values = table.rest();
  values.insert_or_assign("library", loaded.file.string());
  Parameters parameters{std::move(values)};
  (void)parameters.text("library", "");
  std::unique_ptr<Controller> controller;
  const std::string who = "controller " + pure::one_line(loaded.name) + ", robot " + std::to_string(robot.id);
  const InsideController inside{who.c_str(), 0};
  try {
    const KeptFloatingPoint kept;
    controller = loaded.library->make(robot, parameters);
  } catch (const ParameterError& error) {
    table.fail(error.key(), text_of(error));
  } catch (const std::exception& error) {
    throw StartError{who + ": cannot be made: " + text_of(error)};
  } catch (...) {
    throw StartError{who + ": cannot be made: its constructor threw something that is no std::exception"};
  }
  if (!controller) throw StartError{who + ": cannot be made: the library made no controller"};
  for (const std::string& key : parameters.unknown())
    table.fail(key, "unknown key; " + keys_of(loaded.name, parameters));
  return controller;
}

}  // namespace caravan::runtime
