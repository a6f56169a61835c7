// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "experiment/metrics/run_facts.hpp"
#include "idl/world_types.hpp"

namespace caravan::deploy {

/// What the newest statuses say of a run; none: nothing was heard.
[[nodiscard]] experiment::RunEnd run_end(const std::optional<caravan_interfaces::msg::WorldStatus>& world,
                                         const std::optional<caravan_interfaces::msg::RadioStatus>& radio,
                                         double agents_compute_s);

}  // namespace caravan::deploy
