// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

namespace caravan::world {

/// Wall time, as a value.
using Wall = std::chrono::steady_clock::time_point;

struct BarrierConfig {
  std::uint32_t robots = 1;
  bool waits_for_hung = true;                             ///< false: coast, go on without whoever is late
  std::chrono::milliseconds hung_after{2000};             ///< alive and silent for so long: hung
  std::chrono::milliseconds radio_start_patience{10000};  ///< how long the first step waits for a radio
};

/// What an answer means.
enum class Answer : std::uint8_t {
  kCounts,    ///< for this step
  kNextStep,  ///< not for this step: the robot is a member from the next
  kRevives    ///< counts, and makes the robot the member of a step that had none
};

/// Who takes part in the step and who is still awaited: the rules of the lockstep, without time, thread or
/// topic of its own.
///
/// Before the first step everybody is missing and joins by answering stamp 0. Between open() and the next
/// open():
///
///   robot        | answers               | found gone      | late (hung, coasting allowed)
///   -------------+-----------------------+-----------------+------------------------------
///   member       | not awaited any more  | leaves the step | leaves the step, until it answers
///   not a member | member from next open | stays out       | -
///
/// A step that has lost all its members does not end; whoever answers it becomes its member at once.
/// Robots are numbered from 1. The radio is awaited in a step iff it is joined. Whatever makes the run depend
/// on wall time sets disturbed(): a loss, a late joiner, a coasting member.
class Barrier {
 public:
  explicit Barrier(const BarrierConfig& config);

  /// Robots that have not answered stamp 0 yet, or were spawned and have not answered since. The first step
  /// may open when it is empty.
  [[nodiscard]] std::vector<std::uint32_t> missing() const;

  /// A new step begins: its members are those that answered the one before.
  void open(Wall now);
  Answer answer(std::uint32_t robot);
  /// An answer to a step that is over. A robot that was lost or coasted past is here again: from the next
  /// step on it is a member, and awaited. Without this a robot that is slower than the others would never
  /// catch up.
  void answer_late(std::uint32_t robot);
  void answer_radio();
  /// The same of the radio: it is awaited from the next step on.
  void answer_radio_late();
  /// @return true when a member left the step, so that the members changed
  bool lose(std::uint32_t robot, Wall now);
  /// Between two steps: a robot is taken out of the world. Nothing that it answers counts.
  void remove(std::uint32_t robot, Wall now);
  /// Between two steps: it is in the world again.
  /// @param is_here  its agent is there: a member of the next step, awaited in it. Otherwise it is missing,
  ///                 and a member from the step after its first answer on.
  void spawn(std::uint32_t robot, bool is_here);
  /// @return true when the radio was awaited
  bool lose_radio();
  /// Takes out who is late beyond patience: hung members where coasting is allowed, a radio that never came
  /// in the first step.
  /// @return true when somebody was taken out
  bool let_go(Wall now);

  [[nodiscard]] bool is_member(std::uint32_t robot) const;
  [[nodiscard]] std::vector<std::uint32_t> members() const;  ///< sorted
  [[nodiscard]] bool commands_in() const;                    ///< every member has answered
  [[nodiscard]] bool radio_in() const;                       ///< the radio has answered, or is not awaited
  /// Members (and 0 for the radio) that are alive but late at `now`.
  [[nodiscard]] std::vector<std::uint32_t> hung(Wall now) const;
  /// Robots (and 0 for the radio) that were lost and have not come back.
  [[nodiscard]] std::vector<std::uint32_t> gone() const;
  [[nodiscard]] bool disturbed() const { return disturbed_; }

 private:
  enum class Standing : std::uint8_t { kMissing, kJoined, kGone, kCoasting, kRemoved };
  enum class Radio : std::uint8_t { kMissing, kJoined, kGone };
  struct Robot {
    Standing standing = Standing::kMissing;
    bool member = false;    // of the open step
    bool answered = false;  // the open step
  };

  void leave(Robot& robot, Wall now);
  bool let_go_of_radio(Wall now);

  BarrierConfig config_;
  std::vector<Robot> robots_;
  Radio radio_ = Radio::kMissing;
  bool radio_answered_ = false;
  bool radio_returns_ = false;  // with the next open()
  std::uint32_t members_ = 0;
  std::uint32_t awaited_ = 0;  // members that have not answered
  bool started_ = false;
  bool first_step_ = false;
  bool disturbed_ = false;
  Wall patient_since_{};  // the open step began, or its members changed: the radio has to start over
};

}  // namespace caravan::world
