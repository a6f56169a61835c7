// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "radio_emulator/medium/link_rules.hpp"
#include "runtime/pure/agenda.hpp"

namespace caravan::radio {

struct AddRule {
  LinkRule rule;
};
struct ClearRules {};
using RadioAction = std::variant<AddRule, ClearRules>;
using RadioOrder = pure::Order<RadioAction>;

/// Runtime control of the radio: the rules given by operators, and the step from which they apply. Has no
/// topics.
class RadioControl {
 public:
  explicit RadioControl(std::uint32_t robots) : robots_{robots} {}

  /// @param next_step  the first step whose truth has not arrived
  /// @return none if the order is a repetition
  [[nodiscard]] std::optional<pure::Outcome> ask(RadioOrder order, std::uint64_t next_step);
  /// The truth of `step` has arrived: the orders due by then apply to its frames.
  [[nodiscard]] std::vector<pure::Outcome> reach(std::uint64_t step);
  /// The run is over: refuses all further orders.
  [[nodiscard]] std::vector<pure::Outcome> end();

  [[nodiscard]] std::span<const LinkRule> rules() const { return rules_; }
  /// Whether any order has taken effect.
  [[nodiscard]] bool was_used() const { return used_; }

 private:
  [[nodiscard]] std::string refusal_of(const RadioAction& action) const;

  std::uint32_t robots_;
  pure::Agenda<RadioAction> agenda_;
  std::vector<LinkRule> rules_;
  bool used_ = false;
  bool ended_ = false;
};

}  // namespace caravan::radio
