// SPDX-License-Identifier: Apache-2.0
#include "runtime/config/setting.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "runtime/config/toml_text.hpp"

namespace caravan::runtime {
namespace {

bool is_letter(char one) { return (one >= 'a' && one <= 'z') || (one >= 'A' && one <= 'Z'); }
bool is_digit(char one) { return one >= '0' && one <= '9'; }

std::string trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return "";
  return std::string{text.substr(begin, text.find_last_not_of(" \t") + 1 - begin)};
}

/// Splits at commas that are inside no bracket, brace or quote.
std::vector<std::string> split_values(std::string_view text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char one = text[i];
    if (quote == '"' && one == '\\' && i + 1 < text.size()) {
      parts.back() += one;
      parts.back() += text[++i];
      continue;
    }
    if (quote != 0) {
      if (one == quote) quote = 0;
    } else if (one == '"' || one == '\'') {
      quote = one;
    } else if (one == '[' || one == '{') {
      ++depth;
    } else if (one == ']' || one == '}') {
      --depth;
    } else if (one == ',' && depth == 0) {
      parts.emplace_back();
      continue;
    }
    parts.back() += one;
  }
  for (std::string& part : parts) part = trimmed(part);
  return parts;
}

/// Without the quotes of a text that needs none, so that "full" and full are one value.
std::string plain(const std::string& value) {
  const bool quoted =
      value.size() > 2 && (value.front() == '"' || value.front() == '\'') && value.back() == value.front();
  const std::string inside = quoted ? value.substr(1, value.size() - 2) : "";
  return is_word(inside) ? inside : value;
}

void lay_over(toml::table& tree, toml::table& changes, const std::string& above, const std::string& origin) {
  for (auto&& [key, node] : changes) {
    const std::string name = above + std::string{key.str()};
    toml::node* there = tree.get(key.str());
    if (there != nullptr && node.is_table()) {
      if (!there->is_table()) {
        throw StartError{
            origin + ": " + name + " is not a table" +
            (there->is_array() ? "; the elements of a list cannot be set, only the whole list" : "")};
      }
      lay_over(*there->as_table(), *node.as_table(), name + ".", origin);
    } else {
      node.visit([&tree, &key = key](auto&& value) { tree.insert_or_assign(key.str(), std::move(value)); });
    }
  }
}

std::string real_text(double value) {
  if (!std::isfinite(value)) return std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
  std::array<char, 40> text{};
  const std::string digits{text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
  return digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
}

std::string list_text(const toml::array& list) {
  std::string text;
  for (const toml::node& element : list) {
    const std::string one = value_of_node(element);
    if (one.empty()) return "";
    const bool is_text = element.is_string() && one.front() != '"';
    text += (text.empty() ? "[" : ", ") + (is_text ? "\"" + one + "\"" : one);
  }
  return (text.empty() ? "[" : text) + "]";
}

}  // namespace

bool is_key(std::string_view text) {
  bool part_begins = true;
  for (const char one : text) {
    if (one == '.' && part_begins) return false;
    if (one != '.' && one != '_' && one != '-' && !is_letter(one) && !is_digit(one)) return false;
    part_begins = one == '.';
  }
  return !part_begins;
}

bool is_word(std::string_view text) {
  constexpr std::array<std::string_view, 4> kValues = {"true", "false", "nan", "inf"};
  const auto begins = [](char one) { return is_letter(one) || one == '.' || one == '_' || one == '/'; };
  return !text.empty() && begins(text.front()) && std::ranges::find(kValues, text) == kValues.end() &&
         std::ranges::all_of(text, [&](char one) { return begins(one) || is_digit(one) || one == '-'; });
}

std::string value_of_text(std::string_view text) {
  if (is_word(text)) return std::string{text};
  std::string quoted = "\"";
  for (const char one : text) {
    if (one == '"' || one == '\\') quoted += '\\';
    if (one == '\n') {
      quoted += "\\n";
    } else {
      quoted += one;
    }
  }
  return quoted + "\"";
}

std::string value_of_node(const toml::node& node) {
  if (const auto flag = node.value_exact<bool>()) return *flag ? "true" : "false";
  if (const auto whole = node.value_exact<std::int64_t>()) return std::to_string(*whole);
  if (const auto real = node.value_exact<double>()) return real_text(*real);
  if (const auto text = node.value_exact<std::string>()) return value_of_text(*text);
  return node.is_array() ? list_text(*node.as_array()) : "";
}

KeyValues read_key_values(const std::string& text, const std::string& option) {
  const std::string begin = option + " " + text + ": ";
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos) throw StartError{begin + "is not of the form table.key=value"};
  KeyValues read{.key = trimmed(std::string_view{text}.substr(0, sign)), .values = {}};
  if (!is_key(read.key)) throw StartError{begin + "\"" + read.key + "\" is not a key such as radio.range_m"};
  if (text.find('\n') != std::string::npos) throw StartError{begin + "is more than one line"};
  const std::string values = trimmed(std::string_view{text}.substr(sign + 1));
  if (values.empty()) throw StartError{begin + "has no value"};
  for (const std::string& part : split_values(values)) {
    if (part.empty()) throw StartError{begin + "one of its values is empty"};
    const std::string value = plain(part);
    if (std::ranges::find(read.values, value) != read.values.end())
      throw StartError{begin + "names " + value + " twice"};
    read.values.push_back(value);
  }
  return read;
}

Setting read_setting(const std::string& text, const std::string& option) {
  KeyValues read = read_key_values(text, option);
  if (read.values.size() > 1) {
    throw StartError{option + " " + text + ": takes one value here; a list is in brackets: " + read.key +
                     "=[...]"};
  }
  const std::string origin = option + " " + read.key + "=" + read.values.front();
  return {.key = std::move(read.key), .value = std::move(read.values.front()), .origin = origin};
}

void apply(const Setting& setting, toml::table& tree) {
  const std::string value = is_word(setting.value) ? "\"" + setting.value + "\"" : setting.value;
  toml::table changes = parse_toml_line(setting.key + " = " + value, setting.origin);
  lay_over(tree, changes, "", setting.origin);
}

}  // namespace caravan::runtime
