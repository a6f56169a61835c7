// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace caravan::runtime {

/// The process cannot start: one line that says what, where, why and what to do. Becomes exit code 2.
struct StartError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace caravan::runtime
