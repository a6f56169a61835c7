// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "deploy/kit/quantities.hpp"
#include "deploy/kit/seen.hpp"

namespace caravan::deploy {

/// A condition on the state at one moment: `gone has "robot 2" and members is 3`.
///
/// Each part is a quantity, a comparison (is, is not, <, <=, >, >=, has, lacks) and a value; parts are joined
/// by `and`. A quantity without a value yet fulfils no comparison.
class Condition {
 public:
  /// @throws WordsError
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
