// SPDX-License-Identifier: Apache-2.0
#include "tests/system/vendors/snippets.hpp"

#include <fstream>
#include <sstream>

namespace caravan::test {

std::vector<Snippet> snippets_of(const std::filesystem::path& page) {
  std::vector<Snippet> found;
  std::ifstream lines{page};
  bool is_inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) {
      is_inside = !is_inside;
      if (!is_inside) continue;
      std::istringstream fence{line.substr(3)};
      fence >> found.emplace_back().language >> found.back().file;
    } else if (is_inside) {
      found.back().text += line + "\n";
    }
  }
  return found;
}

}  // namespace caravan::test
