// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace caravan::runtime {

/// What a list of numbers on a command line may hold.
struct NumberListRule {
  std::string option;  ///< as the user wrote it, such as --robots: errors begin with it
  std::uint64_t lowest = 0;
  std::uint64_t highest = 0;
  std::size_t most = 0;  ///< a range beyond it is a slip of the hand
};

/// The numbers that a text such as "1-15" or "1,3,5-8" names, sorted.
/// @throws StartError when it is written otherwise, a range runs backwards, or a number is out of bounds or
///         named twice
[[nodiscard]] std::vector<std::uint64_t> read_number_list(const std::string& text,
                                                          const NumberListRule& rule);

}  // namespace caravan::runtime
