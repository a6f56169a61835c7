// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "experiment/metrics/run_facts.hpp"

namespace caravan::experiment {

/// A scenario's text with some keys changed. The path of a controller in it is made absolute.
///
/// @param file     the scenario's name in messages; relative paths start from its folder
/// @param changes  a dict: "radio.range_m" -> value. A dict changes a table key by key, a list of dicts
/// replaces
///                 a list of tables. Values of NumPy count as those of Python.
/// @param changed_file  the name of the changed scenario in messages
/// @throws runtime::StartError when the text is not TOML or a value has no form in TOML
[[nodiscard]] std::string changed_text(const std::string& text, const std::string& file,
                                       const pybind11::dict& changes, const std::string& changed_file);

/// Reads every table of a scenario but [controller] as the programs do, and builds the world once.
/// @throws runtime::StartError
[[nodiscard]] RunFacts check_text(const std::string& text, const std::string& file);

}  // namespace caravan::experiment
