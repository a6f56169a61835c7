// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

namespace caravan::world {

/// Wall time as a value.
using Wall = std::chrono::steady_clock::time_point;

struct BarrierConfig {
  std::uint32_t robots = 1;
  bool waits_for_hung = true;                  ///< false: coast, that is, go on without late members
  std::chrono::milliseconds hung_after{2000};  ///< alive and silent for this long: hung
  std::chrono::milliseconds radio_start_patience{10000};  ///< time that the first step waits for a radio
};

/// The effect of an answer.
enum class Answer : std::uint8_t {
  kCounts,    ///< counts for this step
  kNextStep,  ///< does not count for this step: the robot is a member from the next one
  kRevives    ///< counts, and makes the robot a member of a step that had none
};

/// Which robots take part in the step and which are still waited for: the rules of the lockstep, without
/// clock, thread or topic.
///
/// Before the first step all robots are missing; each joins by answering stamp 0. Between open() and the next
/// open():
///
///   robot        | answers               | found gone      | late (hung, coasting allowed)
///   -------------+-----------------------+-----------------+------------------------------
///   member       | no longer awaited     | leaves the step | leaves the step, until it answers
///   not a member | member from next open | stays out       | -
///
/// A step that has lost all its members does not end; the first robot that answers it becomes its member at
/// once. Robots are numbered from 1. The radio is awaited in a step iff it is joined. Events that make the
/// run depend on wall time set disturbed(): a loss, a late joiner, a coasting member.
class Barrier {
 public:
  explicit Barrier(const BarrierConfig& config);

  /// Robots that have not answered stamp 0 yet, or were spawned and have not answered since. The first step
  /// may open when this is empty.
  [[nodiscard]] std::vector<std::uint32_t> missing() const;

  /// A new step begins: its members are those that answered the one before.
  void open(Wall now);
  Answer answer(std::uint32_t robot);
  /// An answer to a step that is over. A robot that was lost or coasted past has returned: from the next step
  /// it is a member, and awaited. Without this a robot that is slower than the others would never catch up.
  void answer_late(std::uint32_t robot);
  void answer_radio();
  /// The same for the radio: it is awaited from the next step.
  void answer_radio_late();
  /// @return true when a member left the step, so that the members changed
  bool lose(std::uint32_t robot, Wall now);
  /// Between two steps: removes a robot from the world. Its answers no longer count.
  void remove(std::uint32_t robot, Wall now);
  /// Between two steps: puts a robot back into the world.
  /// @param is_here  its agent is running: the robot is a member of the next step, and awaited in it.
  /// Otherwise
  ///                 it is missing, and a member from the step after its first answer.
  void spawn(std::uint32_t robot, bool is_here);
  /// @return true when the radio was awaited
  bool lose_radio();
  /// Drops members that are too late: hung members if coasting is allowed, and in the first step a radio that
  /// never joined.
  /// @return true when something was dropped
  bool let_go(Wall now);

  [[nodiscard]] bool is_member(std::uint32_t robot) const;
  [[nodiscard]] std::vector<std::uint32_t> members() const;  ///< sorted
  [[nodiscard]] bool commands_in() const;                    ///< every member has answered
  [[nodiscard]] bool radio_in() const;                       ///< the radio has answered, or is not awaited
  /// Members (and 0 for the radio) that are alive but late at `now`.
  [[nodiscard]] std::vector<std::uint32_t> hung(Wall now) const;
  /// Robots (and 0 for the radio) that were lost and have not returned.
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
  Wall patient_since_{};  // start of the open step, or of its last change of members, after which the radio
                          // starts over
};

}  // namespace caravan::world
