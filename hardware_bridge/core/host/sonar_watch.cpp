// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/host/sonar_watch.hpp"

#include <algorithm>
#include <string>

namespace caravan::bridge {
namespace {

using namespace std::chrono_literals;

constexpr std::uint16_t kNothing_mm = 10;  // below the range of any transducer
constexpr Time kStuckAfter = 2s;
constexpr Time kRound = 500ms;  // of all transducers: those that fail together are reported together
constexpr Time kSilentAfter = 3s;

}  // namespace

SonarWatch::Set SonarWatch::stuck(Time now) const {
  Set stuck;
  for (std::size_t i = 0; i < kSonarCount; ++i)
    stuck[i] = zero_since_[i] && now - *zero_since_[i] >= kStuckAfter;
  return stuck;
}

Notice SonarWatch::told_of(const Set& stuck) const {
  if (stuck.none()) return {Notice::Weight::kInfo, "sonars measure again", "sonars at 0"};
  std::string which;
  for (std::size_t i = 0; i < kSonarCount; ++i) {
    if (stuck[i]) which += (which.empty() ? "" : ", ") + std::to_string(i);
  }
  const std::string who = stuck == known_      ? "all sonars read"
                          : stuck.count() == 1 ? "sonar " + which + " reads"
                                               : "sonars " + which + " read";
  return {Notice::Weight::kWarning,
          who + " 0 mm all the time, as if touched: covered or defective? The robot may stand still",
          "sonars at 0"};
}

std::vector<Notice> SonarWatch::watch(std::span<const arcos::Sip::Sonar> readings, Time now) {
  std::vector<Notice> notices;
  for (const arcos::Sip::Sonar& reading : readings) {
    if (reading.index >= kSonarCount) continue;
    known_.set(reading.index);
    auto& since = zero_since_[reading.index];
    if (reading.range_mm >= kNothing_mm) since.reset();
    if (reading.range_mm < kNothing_mm && !since) since = now;
  }
  if (!readings.empty() || !last_reading_) last_reading_ = now;
  const bool silent = now - *last_reading_ >= kSilentAfter;
  if (silent && !told_silent_) {
    notices.push_back(
        {Notice::Weight::kWarning, "the sonars give no readings: are they switched on?", "sonars"});
  }
  if (!silent && told_silent_) {
    notices.push_back({Notice::Weight::kInfo, "the sonars give readings again", "sonars"});
  }
  told_silent_ = silent;
  // Waits for transducers that have just begun to read 0, so that one line names all of them.
  const bool some_begin = std::any_of(zero_since_.begin(), zero_since_.end(), [&](const auto& since) {
    return since && now - *since < kStuckAfter && now - *since >= kStuckAfter - kRound;
  });
  const Set now_stuck = stuck(now);
  if (now_stuck != told_ && !some_begin) {
    told_ = now_stuck;
    notices.push_back(told_of(now_stuck));
  }
  return notices;
}

}  // namespace caravan::bridge
