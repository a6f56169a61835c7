// SPDX-License-Identifier: Apache-2.0
#include "world_server/referee/items.hpp"

#include <utility>

#include "runtime/pure/assert.hpp"

namespace caravan::world {

Items::Items(const ItemRules& rules, std::uint32_t robots)
    : rules_{rules}, grippers_(robots), stock_{rules.items + robots} {}

bool Items::is_at(Point site, const Pose& pose) const {
  return length(Point{pose.x_m, pose.y_m} - site) <= rules_.service_radius_m;
}

std::optional<ItemEvent> Items::grip(std::uint32_t robot, const Pose& pose, bool closed) {
  CARAVAN_ASSERT(robot >= 1 && robot <= grippers_.size());
  const bool was_closed = std::exchange(grippers_[robot - 1].closed, closed);
  if (closed == was_closed) return std::nullopt;
  return closed ? close(robot, pose) : open(robot, pose);
}

void Items::withdraw(std::uint32_t robot) {
  const Gripper left = std::exchange(grippers_[robot - 1], {});
  if (left.holding && rules_.items > 0) ++stock_;
}

std::optional<ItemEvent> Items::close(std::uint32_t robot, const Pose& pose) {
  const bool has_stock = rules_.items == 0 || stock_ > 0;
  if (!has_stock || !is_at(rules_.source, pose)) {
    ++empty_closings_;
    return std::nullopt;
  }
  if (rules_.items > 0) --stock_;
  grippers_[robot - 1].holding = true;
  return ItemEvent{ItemEvent::Kind::kPickUp, robot};
}

std::optional<ItemEvent> Items::open(std::uint32_t robot, const Pose& pose) {
  if (!std::exchange(grippers_[robot - 1].holding, false)) return std::nullopt;
  if (!is_at(rules_.destination, pose)) {
    if (rules_.items > 0) ++stock_;
    return std::nullopt;
  }
  ++delivered_;
  return ItemEvent{ItemEvent::Kind::kDelivery, robot};
}

}  // namespace caravan::world
