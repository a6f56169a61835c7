// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <deque>

#include "experiment/metrics/observation.hpp"

namespace caravan::experiment {

/// How one robot spent its simulated time. The first five add up to all the time accounted for, to the
/// nanosecond.
struct ActivityTimes {
  Time driving{0};
  Time exchanging{0};
  Time avoiding{0};
  Time stuck{0};
  Time idle{0};
  Time longest_stuck{0};  ///< the longest uninterrupted part of `stuck`
  bool operator==(const ActivityTimes&) const = default;
};

/// Accounts for the simulated time of one robot. Time counts as the activity that the robot reports, except
/// where it is stuck: a window of 60 s counts as stuck, from start to end, if the robot never gets 0.5 m away
/// from its position at the start of the window, and exchanges nothing.
///
/// Windows begin at the first step of each simulated second, so stuck time is accurate to a second.
class ActivityAccount {
 public:
  /// Accounts for [from, from + duration), at whose start the robot was at `place`.
  /// @param present  the robot took part; the time of an absent robot is idle and never stuck
  /// @pre intervals follow each other without gap
  void add(Time from, Time duration, const Place& place, Activity activity, bool present);

  /// The times so far.
  [[nodiscard]] ActivityTimes times() const;

 private:
  /// About one second: the steps that begin in it.
  struct Slot {
    Time begin{0};
    Place place;
    std::array<Time, 4> by_activity{};
    bool judged = true;  // no exchange in it and never absent
    bool stuck = false;
  };
  void judge_windows(Time now, const Place& place);
  void settle_front();

  std::deque<Slot> open_;  // the latest window
  ActivityTimes settled_;
  Time stuck_run_{0};
};

}  // namespace caravan::experiment
