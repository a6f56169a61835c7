// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace caravan::world {

/// The physics cannot continue; the text names the robot and the reason. The world that threw it is unusable.
struct PhysicsError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace caravan::world
