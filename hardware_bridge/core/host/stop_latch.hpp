// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace caravan::bridge {

/// Latches the emergency stop until an operator has restarted the robot with its MOTORS button.
///
///   state    | button pressed | released, motors off | released, motors on
///   ---------+----------------+----------------------+------------------------------
///   Free     | Held           | -                    | -
///   Held     | -              | Released             | -; motors are disabled first
///   Released | Held           | -                    | Free: MOTORS was pressed
///
/// "-": no change. The host never enables the motors in Held and Released, even after a new connection.
class StopLatch {
 public:
  enum class Change : std::uint8_t { kNone, kPressed, kReleased, kRestarted };

  /// @param pressed, motors_on  as reported by the robot
  Change see(bool pressed, bool motors_on) {
    if (pressed) {
      if (state_ == State::kHeld) return Change::kNone;
      state_ = State::kHeld;
      return Change::kPressed;
    }
    if (state_ == State::kHeld && !motors_on) {
      state_ = State::kReleased;
      return Change::kReleased;
    }
    if (state_ == State::kReleased && motors_on) {
      state_ = State::kFree;
      return Change::kRestarted;
    }
    return Change::kNone;
  }
  /// True while the wheels must stand and the motors stay off.
  [[nodiscard]] bool is_on() const { return state_ != State::kFree; }
  /// True while the motors must be disabled, so that an operator can enable them.
  [[nodiscard]] bool wants_motors_off() const { return state_ == State::kHeld; }

 private:
  enum class State : std::uint8_t { kFree, kHeld, kReleased };
  State state_ = State::kFree;
};

}  // namespace caravan::bridge
