// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace caravan::runtime {

/// Bounds of a list of numbers on a command line.
struct NumberListRule {
  std::string option;  ///< as the user wrote it, such as --robots: errors begin with it
  std::uint64_t lowest = 0;
  std::uint64_t highest = 0;
  std::size_t most = 0;  ///< greatest length of the list; a longer range is taken for a typing error
};

/// Reads a list of numbers such as "1-15" or "1,3,5-8"; the result is sorted.
/// @throws StartError for another syntax, a range that runs backwards, or a number that is out of bounds or
///         named twice
[[nodiscard]] std::vector<std::uint64_t> read_number_list(const std::string& text,
                                                          const NumberListRule& rule);

}  // namespace caravan::runtime
