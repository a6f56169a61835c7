// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

/// How long tests wait. A test gives the time that something may take on a current idle machine; on a busy or
/// slow machine it waits longer, as measured, so that a test fails because of the programs and not because of
/// other load.
namespace caravan::test {

/// For waits of a few seconds at most. Long, because only a failing test waits that long.
inline constexpr std::chrono::milliseconds kPatience{60'000};

/// How many times longer a process takes now than on a current idle machine, at least 1: the number of
/// processes ready to run per processor, times the slowness of a processor.
[[nodiscard]] double slowness();
/// The same from its parts. @param ready  processes ready to run, without the caller
[[nodiscard]] double slowness(unsigned ready, unsigned processors, double slower_by);

/// A deadline that approaches only as fast as the machine makes progress.
class Patience {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Patience(std::chrono::milliseconds on_an_idle_machine)
      : left_{on_an_idle_machine}, looked_at_{Clock::now()} {}

  /// Measures the machine. Call it often: one measurement counts for all the time since the last call.
  [[nodiscard]] bool is_over();
  /// Counts time that has passed. Of a pause longer than a second it counts one second: the test itself made
  /// no progress then.
  void count(std::chrono::duration<double> passed, double slowness);
  /// Wall time that is left at least.
  [[nodiscard]] std::chrono::duration<double> left() const { return left_; }

 private:
  std::chrono::duration<double> left_;
  Clock::time_point looked_at_;
};

/// The lease of processes whose loss a test waits for, s: short, but long enough that no running process is
/// lost for lack of processor time.
[[nodiscard]] double short_lease_s();
/// Longer by a second and a half, so that everything that appears after a lease has appeared.
[[nodiscard]] std::chrono::milliseconds longer_than_a_short_lease();

/// Waits until `condition()` holds. @return false if it does not hold within `patience`
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
