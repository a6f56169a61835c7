// SPDX-License-Identifier: Apache-2.0
#include "world_server/barrier/barrier.hpp"

#include "runtime/pure/assert.hpp"

namespace caravan::world {

Barrier::Barrier(const BarrierConfig& config) : config_{config}, robots_(config.robots) {}

std::vector<std::uint32_t> Barrier::missing() const {
  std::vector<std::uint32_t> ids;
  for (std::uint32_t i = 0; i < robots_.size(); ++i) {
    if (robots_[i].standing == Standing::kMissing) ids.push_back(i + 1);
  }
  return ids;
}

void Barrier::open(Wall now) {
  first_step_ = !started_;
  started_ = true;
  patient_since_ = now;
  members_ = 0;
  awaited_ = 0;
  for (Robot& robot : robots_) {
    robot.member = robot.standing == Standing::kJoined;
    // The answers to stamp 0 open the first step, and count for it.
    robot.answered = first_step_ && robot.member;
    if (robot.member) ++members_;
    if (robot.member && !robot.answered) ++awaited_;
  }
  radio_answered_ = false;
  if (radio_returns_ && radio_ == Radio::kGone) radio_ = Radio::kJoined;
  radio_returns_ = false;
}

Answer Barrier::answer(std::uint32_t robot) {
  CARAVAN_ASSERT(robot >= 1 && robot <= robots_.size());
  Robot& one = robots_[robot - 1];
  if (one.standing == Standing::kRemoved) return Answer::kNextStep;
  if (one.standing != Standing::kJoined) {
    disturbed_ = disturbed_ || started_;
    one.standing = Standing::kJoined;
  }
  if (one.member) {
    if (!one.answered) --awaited_;
    one.answered = true;
    return Answer::kCounts;
  }
  if (!started_ || members_ > 0) return Answer::kNextStep;
  members_ = 1;
  one.member = one.answered = true;
  return Answer::kRevives;
}

void Barrier::answer_late(std::uint32_t robot) {
  CARAVAN_ASSERT(robot >= 1 && robot <= robots_.size());
  Standing& standing = robots_[robot - 1].standing;
  const bool awaits_its_first = started_ && standing == Standing::kMissing;
  if (standing == Standing::kGone || standing == Standing::kCoasting || awaits_its_first)
    standing = Standing::kJoined;
}

void Barrier::remove(std::uint32_t robot, Wall now) {
  CARAVAN_ASSERT(robot >= 1 && robot <= robots_.size());
  Robot& one = robots_[robot - 1];
  one.standing = Standing::kRemoved;
  if (one.member) leave(one, now);
}

void Barrier::spawn(std::uint32_t robot, bool is_here) {
  CARAVAN_ASSERT(robot >= 1 && robot <= robots_.size());
  robots_[robot - 1].standing = is_here ? Standing::kJoined : Standing::kMissing;
}

void Barrier::leave(Robot& robot, Wall now) {
  patient_since_ = now;
  robot.member = false;
  --members_;
  if (!robot.answered) --awaited_;
}

void Barrier::answer_radio() {
  if (radio_ != Radio::kJoined) {
    disturbed_ = disturbed_ || (started_ && !first_step_);
    radio_ = Radio::kJoined;
  }
  radio_answered_ = true;
}

void Barrier::answer_radio_late() { radio_returns_ = radio_ == Radio::kGone; }

bool Barrier::lose(std::uint32_t robot, Wall now) {
  CARAVAN_ASSERT(robot >= 1 && robot <= robots_.size());
  Robot& one = robots_[robot - 1];
  if (one.standing == Standing::kRemoved) return false;
  if (one.standing == Standing::kMissing || one.standing == Standing::kGone) return false;
  if (!started_) {
    one.standing = Standing::kMissing;
    return false;
  }
  disturbed_ = true;
  one.standing = Standing::kGone;
  if (!one.member) return false;
  leave(one, now);
  return true;
}

bool Barrier::lose_radio() {
  radio_returns_ = false;
  if (radio_ != Radio::kJoined) return false;
  disturbed_ = disturbed_ || started_;
  radio_ = started_ ? Radio::kGone : Radio::kMissing;
  return true;
}

bool Barrier::let_go(Wall now) {
  bool changed = let_go_of_radio(now);
  const bool robots_are_late = now - patient_since_ >= config_.hung_after;
  if (!config_.waits_for_hung && robots_are_late) {
    for (Robot& robot : robots_) {
      if (!robot.member || robot.answered) continue;
      leave(robot, now);
      robot.standing = Standing::kCoasting;
      changed = true;
    }
  }
  disturbed_ = disturbed_ || changed;
  return changed;
}

bool Barrier::let_go_of_radio(Wall now) {
  const bool never_came =
      first_step_ && radio_ == Radio::kMissing && now - patient_since_ >= config_.radio_start_patience;
  const bool coasts = !config_.waits_for_hung && commands_in() && radio_ == Radio::kJoined &&
                      !radio_answered_ && now - patient_since_ >= config_.hung_after;
  if (!never_came && !coasts) return false;
  radio_ = Radio::kGone;
  return true;
}

bool Barrier::is_member(std::uint32_t robot) const {
  return robot >= 1 && robot <= robots_.size() && robots_[robot - 1].member;
}

std::vector<std::uint32_t> Barrier::members() const {
  std::vector<std::uint32_t> ids;
  for (std::uint32_t i = 0; i < robots_.size(); ++i) {
    if (robots_[i].member) ids.push_back(i + 1);
  }
  return ids;
}

bool Barrier::commands_in() const { return started_ && members_ > 0 && awaited_ == 0; }

bool Barrier::radio_in() const {
  const bool awaited = radio_ == Radio::kJoined || (first_step_ && radio_ == Radio::kMissing);
  return radio_answered_ || !awaited;
}

std::vector<std::uint32_t> Barrier::hung(Wall now) const {
  std::vector<std::uint32_t> ids;
  for (std::uint32_t i = 0; i < robots_.size(); ++i) {
    const bool late = robots_[i].member && !robots_[i].answered && now - patient_since_ >= config_.hung_after;
    if (late || robots_[i].standing == Standing::kCoasting) ids.push_back(i + 1);
  }
  const bool radio_late = commands_in() && !radio_in();
  if (radio_late && now - patient_since_ >= config_.hung_after) ids.push_back(0);
  return ids;
}

std::vector<std::uint32_t> Barrier::gone() const {
  std::vector<std::uint32_t> ids;
  for (std::uint32_t i = 0; i < robots_.size(); ++i) {
    if (robots_[i].standing == Standing::kGone) ids.push_back(i + 1);
  }
  if (radio_ == Radio::kGone) ids.push_back(0);
  return ids;
}

}  // namespace caravan::world
