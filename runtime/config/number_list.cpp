// SPDX-License-Identifier: Apache-2.0
#include "runtime/config/number_list.hpp"

#include <charconv>
#include <set>

#include "runtime/config/start_error.hpp"

namespace caravan::runtime {
namespace {

/// Reads the text from front to back.
class Reader {
 public:
  Reader(const std::string& text, const NumberListRule& rule) : text_{text}, rule_{rule} {}

  [[nodiscard]] bool at_end() const { return place_ == text_.size(); }
  /// Whether `sign` is next; if so, skips it.
  bool passes(char sign) {
    const bool is_next = !at_end() && text_[place_] == sign;
    if (is_next) ++place_;
    return is_next;
  }
  std::uint64_t number() {
    std::uint64_t value = 0;
    const char* const begin = text_.data() + place_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error == std::errc::invalid_argument) refuse_form();
    if (error != std::errc{} || value < rule_.lowest || value > rule_.highest) {
      refuse("its numbers are " + std::to_string(rule_.lowest) + " to " + std::to_string(rule_.highest));
    }
    place_ += static_cast<std::size_t>(end - begin);
    return value;
  }
  [[noreturn]] void refuse_form() const {
    refuse("is not a list of numbers and ranges such as 1-15 or 1,3,5-8");
  }
  [[noreturn]] void refuse(const std::string& reason) const {
    throw StartError{rule_.option + " " + text_ + ": " + reason};
  }

 private:
  const std::string& text_;
  const NumberListRule& rule_;
  std::size_t place_ = 0;
};

}  // namespace

std::vector<std::uint64_t> read_number_list(const std::string& text, const NumberListRule& rule) {
  Reader reader{text, rule};
  std::set<std::uint64_t> numbers;
  do {
    const std::uint64_t first = reader.number();
    const std::uint64_t last = reader.passes('-') ? reader.number() : first;
    if (last < first) {
      reader.refuse("the range " + std::to_string(first) + "-" + std::to_string(last) + " runs backwards");
    }
    if (last - first >= rule.most - numbers.size()) {
      reader.refuse("names more than " + std::to_string(rule.most) + " numbers");
    }
    for (std::uint64_t offset = 0; offset <= last - first; ++offset) {
      if (!numbers.insert(first + offset).second) {
        reader.refuse(std::to_string(first + offset) + " is listed twice");
      }
    }
  } while (reader.passes(','));
  if (!reader.at_end()) reader.refuse_form();
  return {numbers.begin(), numbers.end()};
}

}  // namespace caravan::runtime
