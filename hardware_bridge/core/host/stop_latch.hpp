// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace caravan::bridge {

/// The emergency stop, until an operator has restarted the robot at its MOTORS button.
///
///   state | button pressed  | out, motors off | out, motors on
///   ------+-----------------+-----------------+---------------------------------------------
///   Free  | Held            | -               | -
///   Held  | -               | Released        | -: they are switched off first
///   Released | Held         | -               | Free: somebody has pressed MOTORS
///
/// "-" stays. The host never switches motors on in Held and Released, whatever happens to its connection.
class StopLatch {
 public:
  enum class Change : std::uint8_t { kNone, kPressed, kReleased, kRestarted };

  /// @param pressed, motors_on  what the robot says
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
  /// Wheels stand and motors stay off.
  [[nodiscard]] bool is_on() const { return state_ != State::kFree; }
  /// The motors are to be switched off, so that somebody can switch them on.
  [[nodiscard]] bool wants_motors_off() const { return state_ == State::kHeld; }

 private:
  enum class State : std::uint8_t { kFree, kHeld, kReleased };
  State state_ = State::kFree;
};

}  // namespace caravan::bridge
