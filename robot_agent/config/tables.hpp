// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "robot_agent/core/config.hpp"
#include "runtime/config/toml_table.hpp"

/// Readers of the parts of `[algorithm]`: keys of the table itself, and its subtables.
namespace caravan::agent {

using runtime::kLength_m;
using runtime::kPositive;
using runtime::Range;
using runtime::TomlTable;

inline constexpr Range kDistance_m{0.0, kLength_m.high};
inline constexpr Range kAngle_rad{1e-9, std::numbers::pi};
inline constexpr Range kTolerance_rad{0.0, std::numbers::pi};
inline constexpr Range kShare{0.0, 1.0};
inline constexpr Range kPerMetre{0.0, 10.0};  ///< metres per metre
inline constexpr Range kSpeed_mps{0.0, 100.0};

void read_time(TomlTable& table, const char* key, Time& value, double least_s = 0.0);

void read_sensing(TomlTable& algorithm, Config& config);
void read_navigation(TomlTable& algorithm, Config& config);
void read_paths(TomlTable& algorithm, Config& config);
void read_radio_side(TomlTable& algorithm, Config& config);
void read_task(TomlTable& algorithm, Config& config);

}  // namespace caravan::agent
