// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/controller.hpp>

#include "robot_agent/core/agent.hpp"

namespace caravan::agent {

/// The paper's agent as a controller.
class PaperController final : public Controller {
 public:
  explicit PaperController(const Config& config) : agent_{config} {}
  [[nodiscard]] caravan::Outputs step(const caravan::Inputs& inputs) override;

 private:
  Agent agent_;
  Inputs inputs_;  // of the last step; kept for the memory of its frames
};

/// What a controller is told of robot `config.id`.
[[nodiscard]] Robot robot_of(const Config& config);
/// The destination where the robot sees it, as the paper's agent does.
[[nodiscard]] std::optional<Position> destination_in_sight(const caravan::Sensors& sensors,
                                                           const Config& config);

}  // namespace caravan::agent
