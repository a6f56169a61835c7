// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/config/robot_list.hpp"

#include <charconv>
#include <set>

#include "runtime/config/start_error.hpp"

namespace caravan::agent {
namespace {

constexpr std::uint32_t kHighest = 65535;  // as on the radio

/// Reads the text from front to back.
class Reader {
 public:
  explicit Reader(const std::string& text) : text_{text} {}

  [[nodiscard]] bool at_end() const { return place_ == text_.size(); }
  /// Whether `sign` comes next; passes over it.
  bool passes(char sign) {
    const bool is_next = !at_end() && text_[place_] == sign;
    if (is_next) ++place_;
    return is_next;
  }
  std::uint32_t number() {
    std::uint32_t value = 0;
    const char* const begin = text_.data() + place_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error != std::errc{} || value < 1 || value > kHighest) refuse("a number from 1 to 65535 is missing");
    place_ += static_cast<std::size_t>(end - begin);
    return value;
  }
  [[noreturn]] void refuse(const std::string& reason) const {
    throw runtime::StartError{"--robots " + text_ + ": " + reason + " (for example 1-15 or 1,3,5-8)"};
  }

 private:
  const std::string& text_;
  std::size_t place_ = 0;
};

}  // namespace

std::vector<std::uint32_t> parse_robot_list(const std::string& text) {
  Reader reader{text};
  std::set<std::uint32_t> robots;
  do {
    const std::uint32_t first = reader.number();
    const std::uint32_t last = reader.passes('-') ? reader.number() : first;
    if (last < first) reader.refuse("a range goes from low to high");
    for (std::uint32_t robot = first; robot <= last; ++robot) {
      if (!robots.insert(robot).second) reader.refuse("robot " + std::to_string(robot) + " is in it twice");
    }
  } while (reader.passes(','));
  if (!reader.at_end()) reader.refuse("numbers and ranges are separated by commas");
  return {robots.begin(), robots.end()};
}

}  // namespace caravan::agent
