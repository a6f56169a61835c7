// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace caravan::pure {

/// A request to a running component that takes effect at the start of a step.
template <typename Action>
struct Order {
  std::string requester;
  std::uint32_t id = 0;       ///< increases with each order of the requester
  std::uint64_t at_step = 0;  ///< 0: the next step
  Action action;
};

/// The result of an order.
struct Outcome {
  enum class Kind : std::uint8_t { kRefused, kScheduled, kDone };
  std::string requester;
  std::uint32_t id = 0;
  Kind kind = Kind::kRefused;
  std::uint64_t step = 0;  ///< from which it takes effect
  std::string reason;      ///< why it was refused
  bool operator==(const Outcome&) const = default;
};

/// Orders that wait for their step. Orders of the same step are due in order of arrival, so equal orders for
/// equal steps give equal runs whenever they arrive.
template <typename Action>
class Agenda {
 public:
  /// @param next_step  the first step that has not begun
  /// @param refusal    why the order cannot be executed at any step; empty if it can
  /// @return none for an order that was accepted or refused before: requesters repeat orders
  std::optional<Outcome> add(Order<Action> order, std::uint64_t next_step, std::string refusal) {
    const auto newest = newest_.find(order.requester);
    if (newest != newest_.end() && order.id <= newest->second) return std::nullopt;
    newest_[order.requester] = order.id;
    if (order.at_step == 0) order.at_step = next_step;
    if (refusal.empty() && order.at_step < next_step) {
      refusal =
          "step " + std::to_string(order.at_step) + " has begun, the next is " + std::to_string(next_step);
    }
    if (refusal.empty() && waiting_.size() >= kMost) refusal = "too many orders are waiting";
    Outcome outcome{order.requester, order.id, Outcome::Kind::kScheduled, order.at_step, std::move(refusal)};
    if (!outcome.reason.empty()) {
      outcome.kind = Outcome::Kind::kRefused;
    } else {
      waiting_.emplace(order.at_step, std::move(order));
    }
    return outcome;
  }

  /// Removes and returns the orders due in `step` or earlier, in order.
  [[nodiscard]] std::vector<Order<Action>> due(std::uint64_t step) {
    return take_until(waiting_.upper_bound(step));
  }
  /// Removes and returns all orders, when no further step will follow.
  [[nodiscard]] std::vector<Order<Action>> rest() { return take_until(waiting_.end()); }

 private:
  static constexpr std::size_t kMost = 1000;
  using Waiting = std::multimap<std::uint64_t, Order<Action>>;

  std::vector<Order<Action>> take_until(typename Waiting::iterator end) {
    std::vector<Order<Action>> taken;
    for (auto one = waiting_.begin(); one != end; ++one) taken.push_back(std::move(one->second));
    waiting_.erase(waiting_.begin(), end);
    return taken;
  }

  Waiting waiting_;  // by step; within a step in order of arrival
  std::map<std::string, std::uint32_t> newest_;
};

}  // namespace caravan::pure
