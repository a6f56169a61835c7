// SPDX-License-Identifier: Apache-2.0
// A library whose name is not in lower_snake_case.
#include <caravan/controller.hpp>

extern "C" __attribute__((visibility("default"))) const caravan::ControllerLibrary* caravan_controller() {
  static constexpr caravan::ControllerLibrary library{
      .name = "My Swarm", .make = [](const caravan::Robot&, caravan::Parameters&) {
        return std::unique_ptr<caravan::Controller>{};
      }};
  return &library;
}
