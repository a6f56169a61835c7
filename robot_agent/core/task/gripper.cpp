// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/task/gripper.hpp"

#include "runtime/pure/overload.hpp"

namespace caravan::agent {
void Gripper::arrive_at_source(Time now) {
  if (std::holds_alternative<Empty>(state_)) state_ = Closing{now + patience_};
}

void Gripper::arrive_at_destination(Time now) {
  if (std::holds_alternative<Carrying>(state_)) {
    state_ = Opening{now + patience_};
  } else if (std::holds_alternative<Closing>(state_)) {
    state_ = Empty{};
  }
}

Gripper::Change Gripper::sense(bool holding, Time now) {
  return std::visit(pure::Overload{[&](const Empty&) {
                                     if (holding) state_ = Carrying{};
                                     return Change::kNone;
                                   },
                                   [&](const Closing& closing) {
                                     if (holding) {
                                       state_ = Carrying{};
                                       return Change::kPickedUp;
                                     }
                                     if (now < closing.give_up) return Change::kNone;
                                     state_ = Empty{};
                                     return Change::kNothingThere;
                                   },
                                   [&](const Carrying&) {
                                     if (!holding) state_ = Empty{};
                                     return Change::kNone;
                                   },
                                   [&](const Opening& opening) {
                                     if (!holding) {
                                       state_ = Empty{};
                                       return Change::kDelivered;
                                     }
                                     if (now < opening.give_up) return Change::kNone;
                                     state_ = Carrying{};
                                     return Change::kNotDelivered;
                                   }},
                    state_);
}

bool Gripper::closed() const {
  return std::holds_alternative<Closing>(state_) || std::holds_alternative<Carrying>(state_);
}

}  // namespace caravan::agent
