// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "world_server/barrier/barrier.hpp"
#include "world_server/types.hpp"

namespace caravan::world {

/// Free pacing: how long a command holds.
inline constexpr Time kDeadman = std::chrono::milliseconds{600};

/// The phase of a run.
enum class Phase : std::uint8_t {
  kWaiting,   ///< for robots and observers missing at the start
  kOpen,      ///< the step's sensors are published, its commands are awaited
  kAdvanced,  ///< the bodies have moved, the radio's answer is awaited
  kClosed,    ///< between two steps
  kFinished,  ///< all items are delivered, or the time is over
  kFailed     ///< the physics could not continue
};

/// The next action of the run.
enum class Move : std::uint8_t {
  kNone,         ///< something has not arrived yet, or the run is over
  kStart,        ///< no robot is missing: open the first step
  kAdvance,      ///< move the bodies
  kClose,        ///< end the step
  kOpenOrFinish  ///< the step is over: finish the run, or open the next step when allowed
};

/// The phases of the lockstep: waiting, then open, advanced and closed for each step, finally finished or
/// failed. The Barrier says what is awaited; the Lockstep says what follows. A value without clock or topic.
class Lockstep {
 public:
  /// @param follows_clock  pacing `free`: the clock ends a step, not the arrival of answers
  explicit Lockstep(bool follows_clock) : follows_clock_{follows_clock} {}

  [[nodiscard]] Phase phase() const { return phase_; }
  [[nodiscard]] Time stamp() const { return stamp_; }  ///< of the open step, 0 before the first
  [[nodiscard]] bool is_over() const { return phase_ == Phase::kFinished || phase_ == Phase::kFailed; }
  [[nodiscard]] bool is_in_step() const { return phase_ == Phase::kOpen || phase_ == Phase::kAdvanced; }

  [[nodiscard]] Move next(const Barrier& barrier) const;
  /// Whether an answer to the sensors of `stamp` counts for the open step.
  [[nodiscard]] bool is_current(Time stamp) const;
  /// The first step that has not begun, when `taken` steps have moved the world. Step 0 has begun from the
  /// start: its sensors are published while agents join.
  [[nodiscard]] std::uint64_t first_not_begun(std::uint64_t taken) const;

  /// From kWaiting or kClosed.
  void open(Time stamp);
  /// From kOpen.
  void advance();
  /// From kAdvanced.
  void close();
  /// From kClosed.
  void finish(Time stamp);
  /// From any phase.
  void fail() { phase_ = Phase::kFailed; }

 private:
  bool follows_clock_;
  Phase phase_ = Phase::kWaiting;
  Time stamp_{0};
};

}  // namespace caravan::world
