// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <deque>

#include "experiment/metrics/observation.hpp"

namespace caravan::experiment {

/// Where one robot's simulated time went. The first five add up to all the time accounted for, to the
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

/// Books the simulated time of one robot. Time counts as what the robot says it does, except where it is
/// stuck: a window of 60 s in which it never gets 0.5 m away from where the window began and exchanges
/// nothing is stuck from its first moment to its last.
///
/// Windows begin at the first step of each simulated second, so a stuck stretch is known to a second.
class ActivityAccount {
 public:
  /// Accounts for [from, from + duration), in which the robot left from `place`.
  /// @param present  the robot took part; the time of an absent robot is idle and never stuck
  /// @pre intervals follow one another without gap
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

  std::deque<Slot> open_;  // the youngest window
  ActivityTimes settled_;
  Time stuck_run_{0};
};

}  // namespace caravan::experiment
