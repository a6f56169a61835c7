// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "deploy/kit/quantities.hpp"
#include "deploy/kit/seen.hpp"

namespace caravan::deploy {

/// Something that holds or does not hold at a moment: `gone has "robot 2" and members is 3`.
///
/// Each part is a quantity, a comparison (is, is not, <, <=, >, >=, has, lacks) and a value; parts are joined
/// by `and`. What is not known yet fulfils nothing.
class Condition {
 public:
  /// @throws WordsError
  explicit Condition(const std::string& text);
  /// A condition in C++; `text` says in words what it is.
  Condition(std::string text, std::function<bool(const Seen&)> holds);

  [[nodiscard]] bool holds(const Seen& seen) const;
  [[nodiscard]] const std::string& text() const { return text_; }
  /// Whether a part of it is about this, as in `sends`.
  [[nodiscard]] bool asks_for(std::string_view quantity) const;
  /// The present values of the quantities in it.
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
