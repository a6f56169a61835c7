// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "deploy/control/words.hpp"
#include "deploy/kit/seen.hpp"

namespace caravan::deploy {

/// A number, a word, or a list of names; none: no value yet.
using Value = std::optional<std::variant<double, std::string, std::vector<std::string>>>;
using Quantity = std::function<Value(const Seen&)>;

/// One quantity of expectations.
struct QuantityForm {
  std::string_view form;  ///< `exchanges ROBOT`
  std::string_view meaning;
};
/// The table of quantities.
[[nodiscard]] std::span<const QuantityForm> quantity_forms();

/// The quantity called `name`; takes its arguments from `words`. @throws WordsError
[[nodiscard]] Quantity read_quantity(const std::string& name, Words& words);

}  // namespace caravan::deploy
