// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/activity_account.hpp"

#include <algorithm>
#include <cmath>

namespace caravan::experiment {
namespace {

constexpr Time kWindow = std::chrono::seconds{60};
constexpr Time kSlot = std::chrono::seconds{1};
constexpr double kStuckBelow_m = 0.5;

bool is_near(const Place& a, const Place& b) {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m) < kStuckBelow_m;
}

}  // namespace

void ActivityAccount::add(Time from, Time duration, const Place& place, Activity activity, bool present) {
  if (open_.empty() || from / kSlot != open_.back().begin / kSlot) {
    judge_windows(from, place);
    open_.push_back({.begin = from, .place = place});
  }
  Slot& slot = open_.back();
  const Activity booked = present ? activity : Activity::kIdle;
  slot.by_activity.at(static_cast<std::size_t>(booked)) += duration;
  if (!present || activity == Activity::kExchanging) slot.judged = false;
}

void ActivityAccount::judge_windows(Time now, const Place& place) {
  while (!open_.empty() && now - open_.front().begin >= kWindow) {
    const Place start = open_.front().place;
    const bool stuck = is_near(start, place) && std::ranges::all_of(open_, [&](const Slot& slot) {
                         return slot.judged && is_near(start, slot.place);
                       });
    if (stuck) {
      for (Slot& slot : open_) slot.stuck = true;
    }
    settle_front();
  }
}

void ActivityAccount::settle_front() {
  const Slot& slot = open_.front();
  const auto time_of = [&](Activity activity) {
    return slot.by_activity.at(static_cast<std::size_t>(activity));
  };
  if (slot.stuck) {
    Time all{0};
    for (const Time part : slot.by_activity) all += part;
    settled_.stuck += all;
    stuck_run_ += all;
    settled_.longest_stuck = std::max(settled_.longest_stuck, stuck_run_);
  } else {
    settled_.driving += time_of(Activity::kDriving);
    settled_.exchanging += time_of(Activity::kExchanging);
    settled_.avoiding += time_of(Activity::kAvoiding);
    settled_.idle += time_of(Activity::kIdle);
    stuck_run_ = Time{0};
  }
  open_.pop_front();
}

ActivityTimes ActivityAccount::times() const {
  ActivityAccount rest = *this;
  while (!rest.open_.empty()) rest.settle_front();
  return rest.settled_;
}

}  // namespace caravan::experiment
