// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace caravan::test {

/// A block of code on a page of docs/.
struct Snippet {
  std::string language;
  std::string file;  ///< file name, which follows the language in the opening fence; may be empty
  std::string text;
};

[[nodiscard]] std::vector<Snippet> snippets_of(const std::filesystem::path& page);

}  // namespace caravan::test
