// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "runtime/provenance/provenance.hpp"

namespace caravan::runtime {

/// What could make a repetition come out differently, one line for each: `commit: X; the run had Y`. The
/// command lines are left out; paths are, too, because files with equal content are equal.
///
/// @param then  the run
/// @param now   its repetition
[[nodiscard]] std::vector<std::string> differences(const Provenance& then, const Provenance& now);

}  // namespace caravan::runtime
