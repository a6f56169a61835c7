// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace caravan::test {

/// A sweep with axes that is killed with SIGKILL again and again, at moments that depend on `seed` and on the
/// machine, and started again each time. Expects that no run that was done is lost or done again, and that
/// the tables are those of an uninterrupted sweep, wall times apart.
///
/// @param words  of `caravan sweep`, without --out
/// @param kills  how often
void expect_to_survive_kills(const std::vector<std::string>& words, int kills, std::uint64_t seed);

}  // namespace caravan::test
