// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/config/toml_table.hpp"

namespace caravan::deploy {

/// Changes of a scenario by the command line.
struct Overrides {
  std::optional<std::string> mode;      ///< algorithm.mode
  std::optional<std::uint64_t> seed;    ///< seed; at most 2^63 - 1, as TOML has it
  std::optional<std::uint32_t> robots;  ///< robots.count
  std::optional<std::uint32_t> items;   ///< experiment.items
  std::optional<double> max_time_s;     ///< experiment.max_time_s
  std::optional<std::string> pacing;    ///< experiment.pacing
  std::optional<std::string>
      controller;  ///< controller.library, "paper" or a path from the working directory
};

/// @throws StartError when one of the keys is one that the command line changes by another option, too
void refuse_clash(const std::string& key, const std::string& origin, const Overrides& overrides);

/// The settings of --set.
/// @throws StartError for a wrong form, a key that is set twice, or refuse_clash()
[[nodiscard]] runtime::Settings read_settings(const std::vector<std::string>& sets,
                                              const Overrides& overrides);

/// A controller of the command line: "paper", empty, or the absolute form of a path from the working
/// directory.
[[nodiscard]] std::string absolute_controller(const std::string& given);
/// The controller of the robots: that of the command line, else the scenario's. "paper" or an absolute path.
[[nodiscard]] std::string controller_of(const runtime::TomlDocument& scenario, const Overrides& overrides);

/// The text of the scenario with the changes, its name and its controller's absolute path in it. Read again
/// it gives the same values, to the last bit.
[[nodiscard]] std::string effective_text(const runtime::TomlDocument& scenario, const Overrides& overrides);

}  // namespace caravan::deploy
