// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace caravan::world {

/// The physics cannot go on: which robot, and why. The world that threw it is of no use any more.
struct PhysicsError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace caravan::world
