// SPDX-License-Identifier: Apache-2.0
#include "runtime/config/toml_table.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "runtime/config/toml_text.hpp"

namespace caravan::runtime {
namespace {

constexpr std::array<std::string_view, 9> kRootKeys = {
    "name", "seed", "world", "robots", "radio", "algorithm", "experiment", "bridge", "controller"};

std::string at_line(const std::string& file, const toml::node* node) {
  if (node == nullptr || node->source().begin.line == 0) return file;
  if (node->source().path) return *node->source().path;  // of a Setting
  return file + ":" + std::to_string(node->source().begin.line);
}

std::string to_text(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

std::string out_of_range(double value, Range range) {
  const bool has_low = range.low > -std::numeric_limits<double>::max();
  const bool has_high = range.high < std::numeric_limits<double>::max();
  const std::string is = ", is " + to_text(value);
  if (range.low == kPositive.low)
    return "must be above 0" + (has_high ? " and at most " + to_text(range.high) : "") + is;
  if (has_low && has_high) return "must be " + to_text(range.low) + " to " + to_text(range.high) + is;
  return has_low ? "must be at least " + to_text(range.low) + is
                 : "must be at most " + to_text(range.high) + is;
}

/// The number in `node`, or what is wrong with it.
std::optional<double> number_in(const toml::node& node, Range range, std::string& wrong) {
  const auto value = node.value<double>();
  if (!node.is_number() || !value) {
    wrong = "must be a number";
  } else if (!std::isfinite(*value)) {
    wrong = "must be finite";
  } else if (*value < range.low || *value > range.high) {
    wrong = out_of_range(*value, range);
  } else {
    return value;
  }
  return std::nullopt;
}

std::optional<std::array<double, 2>> pair_in(const toml::node& node, Range range, std::string& wrong) {
  const toml::array* array = node.as_array();
  if (array == nullptr || array->size() != 2) {
    wrong = "must be a pair of numbers [x, y]";
    return std::nullopt;
  }
  const auto x = number_in(*array->get(0), range, wrong);
  if (!x) return std::nullopt;
  const auto y = number_in(*array->get(1), range, wrong);
  if (!y) return std::nullopt;
  return std::array<double, 2>{*x, *y};
}

std::optional<TomlTable::Value> value_in(const toml::node& node) {
  if (const auto flag = node.value_exact<bool>()) return *flag;
  if (const auto whole = node.value_exact<std::int64_t>()) return *whole;
  if (const auto real = node.value_exact<double>()) return *real;
  if (const auto text = node.value_exact<std::string>()) return *text;
  const toml::array* array = node.as_array();
  if (array == nullptr) return std::nullopt;
  std::vector<double> numbers;
  for (const toml::node& element : *array) {
    std::string wrong;
    const auto number = number_in(element, {}, wrong);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace

TomlTable::TomlTable(std::string file, std::string name, const toml::table* table)
    : file_{std::move(file)}, name_{std::move(name)}, table_{table} {}

const toml::node* TomlTable::find(std::string_view key) {
  asked_.emplace(key);
  return table_ == nullptr ? nullptr : table_->get(key);
}

std::map<std::string, TomlTable::Value> TomlTable::rest() {
  std::map<std::string, Value> values;
  if (table_ == nullptr) return values;
  for (const auto& [key, node] : *table_) {
    if (!asked_.emplace(key.str()).second) continue;
    const auto value = value_in(node);
    if (!value) fail_at(&node, key.str(), "must be a number, a text, true or false, or a list of numbers");
    values.emplace(key.str(), *value);
  }
  return values;
}

bool TomlTable::has(std::string_view key) const { return table_ != nullptr && table_->contains(key); }

void TomlTable::fail_at(const toml::node* node, std::string_view key, const std::string& reason) const {
  const std::string full = name_.empty() ? std::string{key} : name_ + "." + std::string{key};
  const std::string place = at_line(file_, node);
  const bool is_named = node != nullptr && node->source().path && place.find(full + "=") != std::string::npos;
  throw StartError{place + ": " + (is_named ? "" : full + ": ") + reason};
}

std::string TomlTable::place_of(std::string_view key) const {
  return at_line(file_, table_ == nullptr ? nullptr : table_->get(key));
}

std::string TomlTable::value(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) return "";
  std::string text = value_of_node(*node);
  if (text.empty()) fail_at(node, key, "must be a number, a text, true or false, or a list of these");
  return text;
}

std::vector<std::string> TomlTable::values_in(const toml::node& node, std::string_view key) const {
  const toml::array* array = node.as_array();
  if (array == nullptr || array->empty()) fail_at(&node, key, "must be a list of at least one value");
  std::vector<std::string> values;
  for (const toml::node& element : *array) {
    values.push_back(value_of_node(element));
    if (values.back().empty())
      fail_at(&element, key, "must be a list of numbers, texts, true or false, or lists");
  }
  return values;
}

std::vector<std::string> TomlTable::values(std::string_view key) {
  const toml::node* node = find(key);
  return node == nullptr ? std::vector<std::string>{} : values_in(*node, key);
}

std::vector<std::vector<std::string>> TomlTable::rows(std::string_view key) {
  std::vector<std::vector<std::string>> rows;
  const toml::node* node = find(key);
  if (node == nullptr) return rows;
  const toml::array* array = node->as_array();
  if (array == nullptr || array->empty()) fail_at(node, key, "must be a list of at least one list of values");
  for (const toml::node& element : *array) rows.push_back(values_in(element, key));
  return rows;
}

void TomlTable::fail(std::string_view key, const std::string& reason) const {
  const toml::node* node = table_ == nullptr ? nullptr : table_->get(key);
  fail_at(node == nullptr ? table_ : node, key, reason);
}

void TomlTable::read(std::string_view key, double& value, Range range) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  std::string wrong;
  const auto number = number_in(*node, range, wrong);
  if (!number) fail_at(node, key, wrong);
  value = *number;
}

void TomlTable::read(std::string_view key, std::uint32_t& value, Range range) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const auto whole = node->value_exact<std::int64_t>();
  if (!whole) fail_at(node, key, "must be a whole number");
  const auto number = static_cast<double>(*whole);
  if (number < range.low || number > range.high) fail_at(node, key, out_of_range(number, range));
  value = static_cast<std::uint32_t>(*whole);
}

void TomlTable::read(std::string_view key, std::uint64_t& value) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const auto whole = node->value_exact<std::int64_t>();
  if (!whole || *whole < 0) fail_at(node, key, "must be a whole number of 0 or more");
  value = static_cast<std::uint64_t>(*whole);
}

void TomlTable::read(std::string_view key, bool& value) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const auto flag = node->value_exact<bool>();
  if (!flag) fail_at(node, key, "must be true or false");
  value = *flag;
}

void TomlTable::read(std::string_view key, std::string& value) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const auto text = node->value_exact<std::string>();
  if (!text) fail_at(node, key, "must be a text in quotes");
  value = *text;
}

void TomlTable::read(std::string_view key, std::array<double, 2>& value, Range range) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  std::string wrong;
  const auto pair = pair_in(*node, range, wrong);
  if (!pair) fail_at(node, key, wrong);
  value = *pair;
}

void TomlTable::read(std::string_view key, std::vector<std::array<double, 2>>& value, Range range) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const toml::array* array = node->as_array();
  if (array == nullptr) fail_at(node, key, "must be a list of pairs [[x, y], ...]");
  value.clear();
  for (const toml::node& element : *array) {
    std::string wrong;
    const auto pair = pair_in(element, range, wrong);
    if (!pair) fail_at(&element, key, wrong);
    value.push_back(*pair);
  }
}

void TomlTable::read(std::string_view key, std::vector<double>& value, Range range) {
  constexpr std::size_t kMost = 32;
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const toml::array* array = node->as_array();
  if (array == nullptr || array->empty() || array->size() > kMost) {
    fail_at(node, key, "must be a list of 1 to " + std::to_string(kMost) + " numbers");
  }
  value.clear();
  for (const toml::node& element : *array) {
    std::string wrong;
    const auto number = number_in(element, range, wrong);
    if (!number) fail_at(&element, key, wrong);
    value.push_back(*number);
  }
}

void TomlTable::read_choice(std::string_view key, std::size_t& value,
                            std::initializer_list<std::string_view> words) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const auto text = node->value_exact<std::string>();
  const auto* found = text ? std::find(words.begin(), words.end(), *text) : words.end();
  if (found == words.end()) {
    std::string list;
    for (const std::string_view word : words)
      list += (list.empty() ? "\"" : ", \"") + std::string{word} + "\"";
    fail_at(node, key, "must be one of " + list);
  }
  value = static_cast<std::size_t>(found - words.begin());
}

TomlTable TomlTable::table(std::string_view key) {
  const toml::node* node = find(key);
  if (node != nullptr && !node->is_table()) fail_at(node, key, "must be a table");
  return {file_, name_.empty() ? std::string{key} : name_ + "." + std::string{key},
          node == nullptr ? nullptr : node->as_table()};
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) {
  std::vector<TomlTable> result;
  const toml::node* node = find(key);
  if (node == nullptr) return result;
  const toml::array* array = node->as_array();
  if (array == nullptr) fail_at(node, key, "must be an array of tables");
  for (const toml::node& element : *array) {
    if (!element.is_table()) fail_at(&element, key, "must be an array of tables");
    result.emplace_back(file_, name_.empty() ? std::string{key} : name_ + "." + std::string{key},
                        element.as_table());
  }
  return result;
}

void TomlTable::refuse_unknown() const {
  if (table_ == nullptr) return;
  for (const auto& [key, node] : *table_) {
    if (!asked_.contains(key.str())) fail_at(&node, key.str(), "unknown key");
  }
}

TomlDocument::TomlDocument(std::string file, std::shared_ptr<const toml::table> tree)
    : file_{std::move(file)}, tree_{std::move(tree)} {
  for (const auto& [key, node] : *tree_) {
    if (std::find(kRootKeys.begin(), kRootKeys.end(), key.str()) == kRootKeys.end()) {
      throw StartError{at_line(file_, &node) + ": " + std::string{key.str()} + ": unknown key"};
    }
  }
}

TomlDocument TomlDocument::load(const std::filesystem::path& file, const Settings& settings) {
  return parse(read_toml_file(file, "scenario file"), file.string(), settings);
}

TomlDocument TomlDocument::parse(std::string_view text, std::string name, const Settings& settings) {
  auto tree = std::make_shared<toml::table>(parse_toml(text, name));
  for (const Setting& setting : settings) apply(setting, *tree);
  return {std::move(name), std::move(tree)};
}

TomlTable TomlDocument::root() const { return {file_, "", tree_.get()}; }

TomlTable TomlDocument::table(std::string_view name) const { return root().table(name); }

}  // namespace caravan::runtime
