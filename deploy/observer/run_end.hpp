// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "experiment/metrics/run_facts.hpp"
#include "idl/world_types.hpp"

namespace caravan::deploy {

/// The end of a run according to the latest statuses; none: no status was received.
[[nodiscard]] experiment::RunEnd run_end(const std::optional<caravan_interfaces::msg::WorldStatus>& world,
                                         const std::optional<caravan_interfaces::msg::RadioStatus>& radio,
                                         double agents_compute_s);

}  // namespace caravan::deploy
