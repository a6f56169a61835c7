// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

/// How long tests wait. They say how long something may take on an idle machine of today; on a busy or slow
/// one they wait longer by as much as is measured, so that a test fails for what the programs do and not for
/// what else the machine does.
namespace caravan::test {

/// For what takes seconds at most. Long, since it is only waited out by a test that fails.
inline constexpr std::chrono::milliseconds kPatience{60'000};

/// How many times longer a process takes now than on an idle machine of today, 1 at least: the processes that
/// are ready to run for each processor, times how slow a processor is.
[[nodiscard]] double slowness();
/// The same from its parts. @param ready  processes ready to run, beside the one that asks
[[nodiscard]] double slowness(unsigned ready, unsigned processors, double slower_by);

/// A deadline that comes nearer only as fast as the machine gets on.
class Patience {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Patience(std::chrono::milliseconds on_an_idle_machine)
      : left_{on_an_idle_machine}, looked_at_{Clock::now()} {}

  /// Looks at the machine: to be called often, since it takes what it sees for all the time since last time.
  [[nodiscard]] bool is_over();
  /// Counts time that has passed. Of a pause longer than a second no more than that: then the test itself did
  /// not get on.
  void count(std::chrono::duration<double> passed, double slowness);
  /// At least so much more will pass on the wall clock.
  [[nodiscard]] std::chrono::duration<double> left() const { return left_; }

 private:
  std::chrono::duration<double> left_;
  Clock::time_point looked_at_;
};

/// The lease of processes whose loss a test waits for, s: short, but long enough that none which lives is
/// lost for want of processor time.
[[nodiscard]] double short_lease_s();
/// By a second and a half: so that what shows itself after a lease has shown itself.
[[nodiscard]] std::chrono::milliseconds longer_than_a_short_lease();

/// Waits until `condition()` holds. @return false when it does not within `patience`
template <typename Condition>
[[nodiscard]] bool eventually(Condition condition, std::chrono::milliseconds patience);

// implementation

void pause_until_next_look();

template <typename Condition>
bool eventually(Condition condition, std::chrono::milliseconds patience) {
  Patience left{patience};
  while (!condition()) {
    if (left.is_over()) return condition();
    pause_until_next_look();
  }
  return true;
}

}  // namespace caravan::test
