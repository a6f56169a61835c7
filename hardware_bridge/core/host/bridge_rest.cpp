// SPDX-License-Identifier: Apache-2.0
// When the wheels of a bridged robot may turn, and what is reported while they may not.
#include <algorithm>
#include <string>
#include <utility>

#include "hardware_bridge/core/host/bridge.hpp"

namespace caravan::bridge {

using namespace std::chrono_literals;
using Weight = Notice::Weight;

namespace {

constexpr Time kStopAgain = 500ms;
constexpr Time kTellWaiting = 5s;
constexpr Time kTellAgain = 60s;
constexpr Time kBraking = 200ms;

/// How long a command is carried out: the rest of its time is for braking.
Time holds(Time command_timeout) { return command_timeout - std::min(kBraking, command_timeout / 3); }

}  // namespace

bool Bridge::is_wished(Time now) const { return wished_ && now - *wished_ <= holds(config_.command_timeout); }

bool Bridge::may_move(Time now) const {
  return is_wished(now) && !latch_.is_on() && link_.is_heard(now) && link_.unsafe(now).empty() &&
         fusion_.pose(now).has_value();
}

void Bridge::tick(Time now) {
  link_.tick(now);
  if (config_.fusion.has_gps) gps_.tick(now);
  for (Notice& notice : gps_.take_notices()) effects_.notices.push_back(std::move(notice));
  const bool heard = link_.is_heard(now);
  if (was_heard_ && !heard) note(Weight::kWarning, "robot silent: wheels told to stop");
  if (!heard) stopped_unwished_ = false;
  was_heard_ = heard;
  tell_safety(now);
  tell_position(now);
  keep_still(now);
  tell_what_is_awaited(now);
}

void Bridge::tell_safety(Time now) {
  const std::string unsafe = link_.unsafe(now);
  if (!unsafe.empty() && was_safe_) note(Weight::kWarning, unsafe + ": wheels told to stop", "line");
  if (unsafe.empty() && !was_safe_ && link_.is_running())
    note(Weight::kInfo, "the robot's line works again", "line");
  was_safe_ = unsafe.empty();
}

void Bridge::keep_still(Time now) {
  const bool may = may_move(now);
  if (moved_ && !may && wished_ && !is_wished(now)) stopped_unwished_ = true;
  if (!may && moved_) link_.brake();
  if (!may && now >= stop_due_) link_.stop();
  if (!may && (moved_ || now >= stop_due_)) stop_due_ = now + kStopAgain;
  moved_ = may;
}

/// Reports with the next SIP. The agent of a silent robot has nothing to answer; then only the silence is
/// reported.
void Bridge::tell_of_missing_commands() {
  if (!std::exchange(stopped_unwished_, false)) return;
  note(Weight::kWarning,
       "no command for " + std::to_string(holds(config_.command_timeout) / 1ms) + " ms: wheels stopped");
}

void Bridge::tell_position(Time now) {
  const bool has = fusion_.has_position(now);
  if (has == had_position_) return;
  had_position_ = has;
  if (has) return note(Weight::kInfo, "position known", "position");
  std::string why = "position lost (GPS): wheels stopped";
  const Time limit = config_.fusion.gps_timeout;
  if (gps_.period() > limit) {
    why += "; the receiver gives a fix every " + in_seconds(*gps_.period()) + ", limit " + in_seconds(limit) +
           ": raise bridge.gps_timeout_s or the receiver's rate";
  }
  note(Weight::kWarning, why, "position");
}

void Bridge::tell_what_is_awaited(Time now) {
  if (moved_ || !tell_due_) tell_due_ = now + kTellWaiting;
  if (now < *tell_due_) return;
  tell_due_ = now + kTellAgain;
  std::string awaited;
  const auto await = [&](bool is_here, const char* what) {
    if (!is_here) awaited += (awaited.empty() ? "" : ", ") + std::string{what};
  };
  await(link_.is_heard(now), "the robot");
  await(link_.unsafe(now).empty(), "a line that works in both directions without delay");
  await(!latch_.is_on(), "the MOTORS button after an emergency stop");
  await(fusion_.pose(now).has_value(), "its position");
  await(is_wished(now), "the agent's commands");
  note(Weight::kInfo, "wheels at rest, waiting for: " + awaited);
}

Time Bridge::next_deadline(Time now) const {
  Time next = now + kStopAgain;
  if (const auto link = link_.next_deadline()) next = std::min(next, *link);
  if (moved_) {
    next = std::min(next, *wished_ + holds(config_.command_timeout) + 1ns);
    next = std::min(next, fusion_.loses_position_at(now) + 1ns);
  }
  if (was_heard_) next = std::min(next, link_.silent_at());
  return next;
}

}  // namespace caravan::bridge
