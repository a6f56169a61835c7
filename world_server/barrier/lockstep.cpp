// SPDX-License-Identifier: Apache-2.0
#include "world_server/barrier/lockstep.hpp"

#include "runtime/pure/assert.hpp"

namespace caravan::world {

Move Lockstep::next(const Barrier& barrier) const {
  switch (phase_) {
    case Phase::kWaiting:
      return barrier.missing().empty() ? Move::kStart : Move::kNone;
    case Phase::kOpen:
      return !follows_clock_ && barrier.commands_in() ? Move::kAdvance : Move::kNone;
    case Phase::kAdvanced:
      return !follows_clock_ && barrier.radio_in() ? Move::kClose : Move::kNone;
    case Phase::kClosed:
      return Move::kOpenOrFinish;
    case Phase::kFinished:
    case Phase::kFailed:
      break;
  }
  return Move::kNone;
}

bool Lockstep::is_current(Time stamp) const {
  if (phase_ == Phase::kFinished) return false;
  return follows_clock_ ? stamp_ - stamp <= kDeadman : stamp == stamp_;
}

std::uint64_t Lockstep::first_not_begun(std::uint64_t taken) const {
  if (phase_ == Phase::kWaiting) return 1;
  return taken + (phase_ == Phase::kOpen ? 1 : 0);
}

void Lockstep::open(Time stamp) {
  CARAVAN_ASSERT(phase_ == Phase::kWaiting || phase_ == Phase::kClosed);
  phase_ = Phase::kOpen;
  stamp_ = stamp;
}

void Lockstep::advance() {
  CARAVAN_ASSERT(phase_ == Phase::kOpen);
  phase_ = Phase::kAdvanced;
}

void Lockstep::close() {
  CARAVAN_ASSERT(phase_ == Phase::kAdvanced);
  phase_ = Phase::kClosed;
}

void Lockstep::finish(Time stamp) {
  CARAVAN_ASSERT(phase_ == Phase::kClosed);
  phase_ = Phase::kFinished;
  stamp_ = stamp;
}

}  // namespace caravan::world
