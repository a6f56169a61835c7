// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <caravan/seen.hpp>

namespace caravan::deploy {

class Words;

/// A number, a word, or a list of names; none: no value yet.
using Value = std::optional<std::variant<double, std::string, std::vector<std::string>>>;
using Quantity = std::function<Value(const Seen&)>;

/// A condition on the state at one moment: `gone has "robot 2" and members is 3`.
///
/// Each part is a quantity, a comparison (is, is not, <, <=, >, >=, has, lacks) and a value; parts are joined
/// by `and`. A quantity without a value yet fulfils no comparison. `caravan deploy --help` lists the
/// quantities.
class Condition {
 public:
  /// @throws WordsError, a std::runtime_error
  explicit Condition(const std::string& text);
  /// A condition in C++; `text` describes it.
  Condition(std::string text, std::function<bool(const Seen&)> holds);

  [[nodiscard]] bool holds(const Seen& seen) const;
  [[nodiscard]] const std::string& text() const { return text_; }
  /// Whether a part uses `quantity`, such as `sends`.
  [[nodiscard]] bool asks_for(std::string_view quantity) const;
  /// The current values of its quantities.
  [[nodiscard]] std::string values(const Seen& seen) const;

 private:
  struct Part {
    std::string name;
    Quantity quantity;
    std::string comparison;
    std::string value;
  };
  static Part read_part(Words& words);
  static bool compare(const Value& value, const std::string& comparison, const std::string& with);

  std::string text_;
  std::vector<Part> parts_;
  std::function<bool(const Seen&)> holds_;  // instead of parts
};

}  // namespace caravan::deploy
