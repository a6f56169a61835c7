// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "robot_agent/core/types.hpp"

namespace caravan::agent {

/// The state of the gripper: it closes at the source and opens at the destination. Only `holding` confirms
/// success.
///
///   state    | at the source | at the destination | holding                              | not holding
///   ---------+---------------+--------------------+--------------------------------------+-----------------------------------
///   Empty    | Closing       | -                  | Carrying                             | -
///   Closing  | -             | Empty              | Carrying, kPickedUp                  | past deadline: Empty, kNothingThere
///   Carrying | -             | Opening            | -                                    | Empty
///   Opening  | -             | -                  | past deadline: Carrying, kNotDelivered | Empty, kDelivered
class Gripper {
 public:
  enum class Change : std::uint8_t { kNone, kPickedUp, kNothingThere, kDelivered, kNotDelivered };

  /// @param patience  time for `holding` to follow a command
  explicit Gripper(Time patience = std::chrono::milliseconds{300}) : patience_{patience} {}

  void arrive_at_source(Time now);
  void arrive_at_destination(Time now);
  /// Updates the state from the sensors of this step. @return the change
  [[nodiscard]] Change sense(bool holding, Time now);
  [[nodiscard]] bool closed() const;

 private:
  struct Empty {};
  struct Closing {
    Time give_up;
  };
  struct Carrying {};
  struct Opening {
    Time give_up;
  };
  Time patience_;
  std::variant<Empty, Closing, Carrying, Opening> state_;
};

}  // namespace caravan::agent
