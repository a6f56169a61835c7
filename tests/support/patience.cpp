// SPDX-License-Identifier: Apache-2.0
#include "tests/support/patience.hpp"

#include <time.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <thread>
#include <vector>

namespace caravan::test {
namespace {

constexpr std::chrono::milliseconds kLookPeriod{5};
constexpr std::chrono::duration<double> kMostOfAPause{1.0};
constexpr std::size_t kSorted = 20'000;
constexpr double kSortedInS = 0.001;  // on a processor of 2020, in an optimised build
constexpr double kShortLease_s = 2.0;
constexpr double kLongestShortLease_s = 10.0;

double processor_time_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double sorting_takes_s() {
  std::vector<std::uint32_t> numbers(kSorted);
  std::uint32_t number = 1;
  for (std::uint32_t& one : numbers) one = number = number * 1664525U + 1013904223U;
  const double before = processor_time_s();
  std::sort(numbers.begin(), numbers.end());
  return processor_time_s() - before;
}

/// Factor by which a processor of this machine is slower: the best of three tries.
double slower_by() {
  static const double measured =
      std::min({sorting_takes_s(), sorting_takes_s(), sorting_takes_s()}) / kSortedInS;
  return measured;
}

/// Number of processes that run or are ready to run, without this one.
unsigned ready() {
  std::ifstream file{"/proc/loadavg"};
  double average = 0.0;
  unsigned running = 1;
  file >> average >> average >> average >> running;
  return running > 0 ? running - 1 : 0;
}

}  // namespace

double slowness() { return slowness(ready(), std::thread::hardware_concurrency(), slower_by()); }

double slowness(unsigned ready, unsigned processors, double slower_by) {
  const double shared_by = static_cast<double>(ready + 1) / static_cast<double>(std::max(1U, processors));
  return std::max(1.0, shared_by) * std::max(1.0, slower_by);
}

bool Patience::is_over() {
  const Clock::time_point now = Clock::now();
  count(now - looked_at_, slowness());
  looked_at_ = now;
  return left_.count() <= 0.0;
}

void Patience::count(std::chrono::duration<double> passed, double slowness) {
  left_ -= std::min(passed, kMostOfAPause) / slowness;
}

double short_lease_s() {
  static const double lease_s = [] {
    double sum = 0.0;
    constexpr int kLooks = 20;
    for (int i = 0; i < kLooks; ++i) {
      sum += slowness();
      pause_until_next_look();
    }
    return std::min(kShortLease_s * sum / kLooks, kLongestShortLease_s);
  }();
  return lease_s;
}

std::chrono::milliseconds longer_than_a_short_lease() {
  using std::chrono::milliseconds;
  return std::chrono::duration_cast<milliseconds>(std::chrono::duration<double>{short_lease_s() + 1.5});
}

void pause_until_next_look() { std::this_thread::sleep_for(kLookPeriod); }

}  // namespace caravan::test
