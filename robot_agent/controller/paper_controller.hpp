// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/controller.hpp>

#include "robot_agent/core/agent.hpp"

namespace caravan::agent {

/// Adapts the paper's agent to the Controller interface.
class PaperController final : public Controller {
 public:
  explicit PaperController(const Config& config) : agent_{config} {}
  [[nodiscard]] caravan::Outputs step(const caravan::Inputs& inputs) override;

 private:
  Agent agent_;
  Inputs inputs_;  // of the last step; a member so that the memory of its frames is reused
};

/// Description of robot `config.id` for its controller.
[[nodiscard]] Robot robot_of(const Config& config);
/// The destination, if the robot sees it by the rule of the paper's agent (sees_destination()).
[[nodiscard]] std::optional<Position> destination_in_sight(const caravan::Sensors& sensors,
                                                           const Config& config);

}  // namespace caravan::agent
