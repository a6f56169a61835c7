// SPDX-License-Identifier: Apache-2.0
#include "radio_emulator/medium/radio_control.hpp"

#include <string>
#include <utility>

#include "runtime/pure/overload.hpp"

namespace caravan::radio {
namespace {

constexpr std::size_t kMostRules = 1000;

}  // namespace

std::string RadioControl::refusal_of(const RadioAction& action) const {
  const auto* add = std::get_if<AddRule>(&action);
  if (add == nullptr) return "";
  for (const auto& robots : {add->rule.robots, add->rule.others}) {
    for (const std::uint32_t robot : robots) {
      if (robot < 1 || robot > robots_)
        return "there is no robot " + std::to_string(robot) + ", only 1 to " + std::to_string(robots_);
    }
  }
  if (add->rule.loss && !(*add->rule.loss >= 0.0 && *add->rule.loss <= 1.0)) return "the loss must be 0 to 1";
  if (add->rule.area) {
    const Area& area = *add->rule.area;
    if (!(area.low_x_m <= area.high_x_m && area.low_y_m <= area.high_y_m))
      return "the area's first corner must be its lower left one";
  }
  return rules_.size() < kMostRules ? "" : "too many rules: clear them first";
}

std::optional<pure::Outcome> RadioControl::ask(RadioOrder order, std::uint64_t next_step) {
  std::string refusal = ended_ ? "the run has ended" : refusal_of(order.action);
  return agenda_.add(std::move(order), next_step, std::move(refusal));
}

std::vector<pure::Outcome> RadioControl::reach(std::uint64_t step) {
  std::vector<pure::Outcome> outcomes;
  for (const RadioOrder& order : agenda_.due(step)) {
    std::visit(pure::Overload{[this](const AddRule& add) { rules_.push_back(add.rule); },
                              [this](const ClearRules&) { rules_.clear(); }},
               order.action);
    used_ = true;
    outcomes.push_back({order.requester, order.id, pure::Outcome::Kind::kDone, step, ""});
  }
  return outcomes;
}

std::vector<pure::Outcome> RadioControl::end() {
  ended_ = true;
  std::vector<pure::Outcome> outcomes;
  for (const RadioOrder& order : agenda_.rest()) {
    outcomes.push_back({order.requester, order.id, pure::Outcome::Kind::kRefused, order.at_step,
                        "the run ended before step " + std::to_string(order.at_step)});
  }
  return outcomes;
}

}  // namespace caravan::radio
