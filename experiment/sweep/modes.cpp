// SPDX-License-Identifier: Apache-2.0
#include "experiment/sweep/modes.hpp"

#include <algorithm>

#include "runtime/config/start_error.hpp"

namespace caravan::experiment {
namespace {

std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char letter : text) {
    if (letter == ',') {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

}  // namespace

std::vector<std::string> read_modes(const std::string& text) {
  std::vector<std::string> modes;
  for (const std::string& mode : parts_of(text)) {
    if (mode != "none" && mode != "partial" && mode != "full") {
      throw runtime::StartError{"--modes " + text + ": \"" + mode + "\" is not none, partial or full"};
    }
    if (std::ranges::count(modes, mode) > 0) {
      throw runtime::StartError{"--modes " + text + ": names " + mode + " twice"};
    }
    modes.push_back(mode);
  }
  return modes;
}

}  // namespace caravan::experiment
