// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "robot_agent/core/config.hpp"
#include "robot_agent/core/types.hpp"

namespace caravan::agent {

/// One robot's whole behaviour: the paper's Algorithm 1. A function of its inputs so far: equal inputs, equal
/// outputs.
class Agent {
 public:
  explicit Agent(const Config& config);
  ~Agent();
  Agent(Agent&&) noexcept;
  Agent& operator=(Agent&&) noexcept;

  /// One step. Time must not go back. An agent without position (NaN) stops.
  [[nodiscard]] Outputs step(const Inputs& inputs);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace caravan::agent
