// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace caravan::experiment {

/// A scenario's text with some keys changed. The path of a controller in it is made absolute.
///
/// @param file     the scenario's name in messages; relative paths start from its folder
/// @param changes  a dict: "radio.range_m" -> value. Lists, and dicts for tables, as TOML has them
/// @throws runtime::StartError when the text is not TOML or a value has no form in TOML
[[nodiscard]] std::string changed_text(const std::string& text, const std::string& file,
                                       const pybind11::dict& changes);

/// Reads every table of a scenario as the programs do, and makes no controllers.
/// @throws runtime::StartError
void check_text(const std::string& text, const std::string& file);

}  // namespace caravan::experiment
