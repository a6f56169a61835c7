// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "world_server/shapes/point.hpp"
#include "world_server/types.hpp"

namespace caravan::world {

struct ItemRules {
  Point source;
  Point destination;
  double service_radius_m = 1.5;  ///< ends included
  std::uint32_t items = 0;        ///< to deliver; 0: any number
};

/// The state of the items and grippers.
///
/// | gripper | within the radius of the source | of the destination | elsewhere |
/// |---|---|---|---|
/// | closes | takes an item if there is one | holds nothing, counted | holds nothing, counted |
/// | opens, holding | item goes back to the stock | delivered | item goes back to the stock |
///
/// The source starts with one more item per robot than must be delivered, so that a robot that is lost with
/// an item in its gripper does not prevent the others from finishing. No item is ever lost: stock + held +
/// delivered is constant. A gripper that keeps its state has no effect.
class Items {
 public:
  Items(const ItemRules& rules, std::uint32_t robots);

  /// Applies a gripper's command. Robots are numbered from 1.
  std::optional<ItemEvent> grip(std::uint32_t robot, const Pose& pose, bool closed);

  /// A robot is removed from the world: its gripper opens, and the item it held returns to the stock.
  void withdraw(std::uint32_t robot);

  [[nodiscard]] bool holds(std::uint32_t robot) const { return grippers_[robot - 1].holding; }
  [[nodiscard]] bool is_closed(std::uint32_t robot) const { return grippers_[robot - 1].closed; }
  [[nodiscard]] std::uint32_t stock() const { return stock_; }
  [[nodiscard]] std::uint32_t delivered() const { return delivered_; }
  [[nodiscard]] std::uint64_t empty_closings() const { return empty_closings_; }
  /// Whether nothing is left to deliver.
  [[nodiscard]] bool all_delivered() const { return rules_.items > 0 && delivered_ >= rules_.items; }

 private:
  struct Gripper {
    bool closed = false;
    bool holding = false;
  };
  [[nodiscard]] bool is_at(Point site, const Pose& pose) const;
  std::optional<ItemEvent> close(std::uint32_t robot, const Pose& pose);
  std::optional<ItemEvent> open(std::uint32_t robot, const Pose& pose);

  ItemRules rules_;
  std::vector<Gripper> grippers_;
  std::uint32_t stock_;
  std::uint32_t delivered_ = 0;
  std::uint64_t empty_closings_ = 0;
};

}  // namespace caravan::world
