// SPDX-License-Identifier: Apache-2.0
#include "deploy/sweep/seeds.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <set>

#include "runtime/config/start_error.hpp"

namespace caravan::deploy {
namespace {

constexpr std::uint64_t kLargest = std::numeric_limits<std::int64_t>::max();

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

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw runtime::StartError{"--seeds " + text + ": " + why};
}

std::uint64_t number_in(const std::string& word, const std::string& text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error == std::errc::result_out_of_range || (error == std::errc{} && number > kLargest)) {
    refuse(text, "seeds are at most " + std::to_string(kLargest));
  }
  if (error != std::errc{} || end != word.data() + word.size()) {
    refuse(text, "is not a list of seeds and ranges such as 1-30 or 1,4,7-9");
  }
  return number;
}

}  // namespace

std::vector<std::uint64_t> read_seeds(const std::string& text) {
  std::set<std::uint64_t> seeds;
  for (const std::string& part : parts_of(text)) {
    const std::size_t dash = part.find('-');
    const std::uint64_t first = number_in(part.substr(0, dash), text);
    const std::uint64_t last = dash == std::string::npos ? first : number_in(part.substr(dash + 1), text);
    if (last < first) refuse(text, "the range " + part + " runs backwards");
    if (last - first >= kMostSeeds) refuse(text, "more than " + std::to_string(kMostSeeds) + " seeds");
    for (std::uint64_t offset = 0; offset <= last - first; ++offset) seeds.insert(first + offset);
    if (seeds.size() > kMostSeeds) refuse(text, "more than " + std::to_string(kMostSeeds) + " seeds");
  }
  return {seeds.begin(), seeds.end()};
}

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

}  // namespace caravan::deploy
