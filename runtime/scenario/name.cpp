// SPDX-License-Identifier: Apache-2.0
#include "runtime/scenario/name.hpp"

#include <algorithm>
#include <filesystem>

namespace caravan::runtime {
namespace {

constexpr std::size_t kLongestName = 64;

bool may_be_in_a_name(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= '0' && letter <= '9') || letter == '.' || letter == '_' || letter == '-';
}

bool is_name(const std::string& text) {
  return !text.empty() && text.size() <= kLongestName && text != "." && text != ".." && text[0] != '-' &&
         std::all_of(text.begin(), text.end(), may_be_in_a_name);
}

}  // namespace

std::string name_of(const TomlDocument& scenario) {
  TomlTable root = scenario.root();
  std::string name;
  root.read("name", name);
  if (root.has("name")) {
    if (!is_name(name)) {
      root.fail(
          "name",
          "must be 1 to " + std::to_string(kLongestName) +
              " letters (a to z), digits, dots, dashes or underlines, not begin with a dash, and not be "
              ". or ..: it becomes part of a folder's name");
    }
    return name;
  }
  name = std::filesystem::path{scenario.file()}.stem().string().substr(0, kLongestName);
  for (char& letter : name) {
    if (!may_be_in_a_name(letter)) letter = '_';
  }
  return is_name(name) ? name : "scenario";
}

}  // namespace caravan::runtime
