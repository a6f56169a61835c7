// SPDX-License-Identifier: Apache-2.0
#include <caravan/condition.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>

#include "deploy/kit/quantities.hpp"

namespace caravan::deploy {
namespace {

std::string to_text(const Value& value) {
  if (!value) return "unknown";
  if (const double* number = std::get_if<double>(&*value)) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%g", *number);
    return text.data();
  }
  if (const std::string* word = std::get_if<std::string>(&*value)) {
    constexpr std::size_t kLongest = 300;
    return word->size() <= kLongest ? "\"" + *word + "\""
                                    : "\"..." + word->substr(word->size() - kLongest) + "\"";
  }
  std::string text;
  for (const std::string& name : std::get<std::vector<std::string>>(*value))
    text += (text.empty() ? "" : ", ") + name;
  return "[" + text + "]";
}

bool compare_numbers(double value, const std::string& comparison, double with) {
  if (comparison == "is") return value == with;
  if (comparison == "is not") return value != with;
  if (comparison == "<") return value < with;
  if (comparison == "<=") return value <= with;
  if (comparison == ">") return value > with;
  return comparison == ">=" && value >= with;
}

}  // namespace

Condition::Condition(const std::string& text) : text_{text} {
  Words words{split(text)};
  do {
    parts_.push_back(read_part(words));
  } while (words.take_if("and"));
  words.end();
}

Condition::Condition(std::string text, std::function<bool(const Seen&)> holds)
    : text_{std::move(text)}, holds_{std::move(holds)} {}

Condition::Part Condition::read_part(Words& words) {
  constexpr std::array<std::string_view, 7> kComparisons{"is", "<", "<=", ">", ">=", "has", "lacks"};
  const std::string name = words.word("what is expected");
  const Quantity quantity = read_quantity(name, words);
  Part part{name, quantity, words.word("a comparison"), ""};
  if (std::find(kComparisons.begin(), kComparisons.end(), part.comparison) == kComparisons.end())
    throw WordsError{"\"" + part.comparison +
                     "\" is not a comparison: use is, is not, <, <=, >, >=, has, lacks"};
  if (part.comparison == "is" && words.take_if("not")) part.comparison = "is not";
  part.value = words.word("the value to compare with");
  double number = 0.0;
  const auto [end, error] = std::from_chars(part.value.data(), part.value.data() + part.value.size(), number);
  const bool is_number = error == std::errc{} && end == part.value.data() + part.value.size();
  if ((part.comparison[0] == '<' || part.comparison[0] == '>') && !is_number)
    throw WordsError{"\"" + part.value + "\" is not a number"};
  return part;
}

bool Condition::compare(const Value& value, const std::string& comparison, const std::string& with) {
  if (!value) return false;
  if (const double* number = std::get_if<double>(&*value)) {
    double other = 0.0;
    const auto [end, error] = std::from_chars(with.data(), with.data() + with.size(), other);
    return error == std::errc{} && end == with.data() + with.size() &&
           compare_numbers(*number, comparison, other);
  }
  if (const std::string* word = std::get_if<std::string>(&*value)) {
    if (comparison == "is") return *word == with;
    if (comparison == "is not") return *word != with;
    if (comparison == "has") return word->find(with) != std::string::npos;
    return comparison == "lacks" && word->find(with) == std::string::npos;
  }
  const auto& names = std::get<std::vector<std::string>>(*value);
  const bool has = std::find(names.begin(), names.end(), with) != names.end();
  if (comparison == "has") return has;
  if (comparison == "lacks") return !has;
  const bool equal = with == "none" ? names.empty() : names.size() == 1 && has;
  return comparison == "is" ? equal : comparison == "is not" && !equal;
}

bool Condition::holds(const Seen& seen) const {
  if (holds_) return holds_(seen);
  return std::all_of(parts_.begin(), parts_.end(), [&](const Part& part) {
    return compare(part.quantity(seen), part.comparison, part.value);
  });
}

bool Condition::asks_for(std::string_view quantity) const {
  return std::any_of(parts_.begin(), parts_.end(), [&](const Part& part) { return part.name == quantity; });
}

std::string Condition::values(const Seen& seen) const {
  std::string text;
  for (const Part& part : parts_)
    text += (text.empty() ? "" : ", ") + part.name + " = " + to_text(part.quantity(seen));
  return text;
}

}  // namespace caravan::deploy
