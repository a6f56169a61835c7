// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <caravan/condition.hpp>
#include "deploy/control/words.hpp"

namespace caravan::deploy {

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
