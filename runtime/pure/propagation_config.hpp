// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "runtime/pure/robot_model.hpp"

namespace caravan::pure {

/// Parameters of the radio model, propagate() in radio_emulator/medium/propagation.hpp. Part of TOML table
/// `[radio]`, which agents and bridges read as strictly as the radio emulator does.
struct PropagationConfig {
  double range_m =
      robot_model::kRadioRange_m;  ///< hard disc: a frame arrives iff distance(sender, receiver) <= range_m
  double loss_probability = 0.0;   ///< within range, independently for each frame and receiver, in [0, 1]
};

}  // namespace caravan::pure
