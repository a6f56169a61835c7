// SPDX-License-Identifier: Apache-2.0
// A controller that was built against another version of the interface.
#include <caravan/controller.hpp>

extern "C" __attribute__((visibility("default"))) const caravan::ControllerLibrary* caravan_controller() {
  static constexpr caravan::ControllerLibrary library{
      .interface = caravan::kControllerInterface + 1, .name = "from the future", .make = nullptr};
  return &library;
}
