// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace caravan::deploy {

/// More than anybody means to run; a range beyond it is a slip of the hand.
inline constexpr std::size_t kMostSeeds = 100'000;

/// The seeds that a text such as `1-30` or `1,4,7-9` names, in ascending order, each once.
///
/// @throws runtime::StartError naming what is wrong: no number, a range that runs backwards, a seed above
///         2^63 - 1 (TOML has no larger integers), more than kMostSeeds
[[nodiscard]] std::vector<std::uint64_t> read_seeds(const std::string& text);

/// The modes that a text such as `none,full` names, in the order given.
///
/// @throws runtime::StartError when it names something that is no mode, or one twice
[[nodiscard]] std::vector<std::string> read_modes(const std::string& text);

}  // namespace caravan::deploy
