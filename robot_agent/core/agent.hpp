// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "robot_agent/core/config.hpp"
#include "robot_agent/core/types.hpp"

namespace caravan::agent {

/// The behaviour of one robot: the paper's Algorithm 1. Deterministic: equal inputs since construction give
/// equal outputs.
class Agent {
 public:
  explicit Agent(const Config& config);
  ~Agent();
  Agent(Agent&&) noexcept;
  Agent& operator=(Agent&&) noexcept;

  /// One step. Inputs::now must not decrease. A robot without a position or heading (NaN) stops.
  [[nodiscard]] Outputs step(const Inputs& inputs);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace caravan::agent
