// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/host/bridge.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "runtime/pure/overload.hpp"

namespace caravan::bridge {

using namespace std::chrono_literals;
using Weight = Notice::Weight;

namespace {

constexpr Time kStopAgain = 500ms;
constexpr Time kTellWaiting = 5s;
constexpr Time kTellAgain = 60s;
constexpr double kCompassUnit_rad = 2.0 * std::numbers::pi / 180.0;
constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

std::variant<ArcosGripper, ImaginedGripper> gripper_of(const BridgeConfig& config) {
  if (config.has_gripper) return ArcosGripper{};
  return ImaginedGripper{config.source_W, config.service_radius_m};
}

}  // namespace

Bridge::Bridge(const BridgeConfig& config)
    : config_{config},
      link_{config.link},
      watcher_{config.low_battery_v},
      projection_{config.arena},
      fusion_{config.fusion},
      gripper_{gripper_of(config)},
      had_position_{!config.fusion.has_gps} {}

void Bridge::robot_up(Time now) {
  odometry_.reset();
  sonars_.forget();
  if (auto* gripper = std::get_if<ArcosGripper>(&gripper_)) gripper->restart();
  link_.up(now);
}

void Bridge::robot_down(Time now) {
  link_.down();
  tick(now);
}

void Bridge::robot_says(std::span<const std::uint8_t> bytes, Time now) {
  for (const arcos::Sip& sip : link_.receive(bytes, now)) on_sip(sip, now);
  tick(now);
}

void Bridge::on_sip(const arcos::Sip& sip, Time now) {
  if (!odometry_) {
    const auto factors = arcos::factors_of(link_.names()->subtype);
    if (!factors) {
      note(Weight::kWarning,
           "unknown robot subtype " + link_.names()->subtype + ": taking its counts for millimetres");
    }
    odometry_.emplace(factors.value_or(arcos::Factors{}));
  }
  for (Notice& notice : watcher_.watch(sip)) effects_.notices.push_back(std::move(notice));
  if (watcher_.take_stop_released()) link_.enable_motors();
  follow(sip, now);
  if (auto* gripper = std::get_if<ArcosGripper>(&gripper_)) {
    if (const auto again = gripper->see(sip, now)) link_.send(*again);
  }
  publish(now);
}

void Bridge::follow(const arcos::Sip& sip, Time now) {
  const arcos::Moved moved = odometry_->follow(sip);
  const double half_turn_m = 0.5 * moved.turned_rad * config_.track_m;
  left_wheel_rad_ += (moved.ahead_m - half_turn_m) / config_.wheel_radius_m;
  right_wheel_rad_ += (moved.ahead_m + half_turn_m) / config_.wheel_radius_m;
  fusion_.move(moved);
  if (config_.fusion.has_compass) {
    fusion_.read_compass(
        projection_.yaw_of_bearing(kCompassUnit_rad * sip.compass + config_.compass_offset_rad));
  }
  sonars_.hear(sip.sonars, now);
}

void Bridge::publish(Time now) {
  Frame frame;
  frame.stamp = last_stamp_ = std::max(now, last_stamp_ + 1us);  // two SIPs may arrive at once
  frame.sonar_range_m = sonars_.ranges_m();
  frame.sonar_age_s = sonars_.ages_s(now);
  const auto pose = fusion_.pose(now);
  frame.x_m = pose ? pose->p_WB.x_m : kNotKnown;
  frame.y_m = pose ? pose->p_WB.y_m : kNotKnown;
  frame.yaw_rad = pose ? pose->yaw_WB_rad : kNotKnown;
  frame.left_wheel_rad = left_wheel_rad_;
  frame.right_wheel_rad = right_wheel_rad_;
  frame.holding = std::visit([](const auto& gripper) { return gripper.is_holding(); }, gripper_);
  effects_.frames.push_back(frame);
}

void Bridge::gps_says(std::span<const std::uint8_t> bytes, Time now) {
  for (const std::string& sentence : sentences_.feed(bytes)) {
    const auto parsed = nmea::parse(sentence);
    if (!parsed) continue;
    std::visit(pure::Overload{[&](const nmea::Gga& gga) {
                                if (gga.quality == 0) return fusion_.lose_fix();
                                on_fix(gga.latitude_deg, gga.longitude_deg, now);
                              },
                              [&](const nmea::Rmc& rmc) {
                                if (!rmc.valid) fusion_.lose_fix();  // its place is GGA's
                              },
                              [](const nmea::Other&) {}},
               *parsed);
  }
  tick(now);
}

void Bridge::on_fix(double latitude_deg, double longitude_deg, Time now) {
  if (!config_.fusion.has_gps) return;
  fusion_.fix(projection_.to_arena(latitude_deg, longitude_deg), now);
}

Wish Bridge::safe(const Wish& wish) {
  if (!std::isfinite(wish.left_mps) || !std::isfinite(wish.right_mps)) {
    if (refused_++ == 0)
      note(Weight::kWarning, "command refused: not finite, wheels stop (further ones are counted)");
    return {0.0, 0.0, wish.gripper_closed};
  }
  const double limit = config_.wheel_limit_mps;
  const Wish clamped{std::clamp(wish.left_mps, -limit, limit), std::clamp(wish.right_mps, -limit, limit),
                     wish.gripper_closed};
  if ((clamped.left_mps != wish.left_mps || clamped.right_mps != wish.right_mps) && clamped_++ == 0) {
    note(Weight::kWarning, "command clamped: beyond the wheel limit (further ones are counted)");
  }
  return clamped;
}

void Bridge::wish(const Wish& wish, Time answers, Time now) {
  if (answers < Time{0} || answers > last_stamp_ || now - answers > config_.command_timeout) {
    ++stale_;
    return;
  }
  wish_ = safe(wish);
  wished_ = now;
  grip(wish_.gripper_closed, now);
  tick(now);
  if (!may_move(now)) return;
  link_.send(arcos::encode(arcos::Order::kWheelSpeeds,
                           arcos::wheel_speeds_argument(wish_.left_mps, wish_.right_mps)));
}

void Bridge::grip(bool closed, Time now) {
  std::visit(pure::Overload{[&](ArcosGripper& gripper) {
                              if (!link_.is_running()) return;
                              if (const auto packet = gripper.want(closed, now)) link_.send(*packet);
                            },
                            [&](ImaginedGripper& gripper) { gripper.want(closed, fusion_.pose(now)); }},
             gripper_);
}

void Bridge::forget_wish(Time now) {
  wished_.reset();
  tick(now);
}

bool Bridge::may_move(Time now) const {
  return wished_ && now - *wished_ <= config_.command_timeout && link_.is_heard(now) &&
         fusion_.pose(now).has_value();
}

void Bridge::tick(Time now) {
  link_.tick(now);
  const bool heard = link_.is_heard(now);
  if (was_heard_ && !heard) note(Weight::kWarning, "robot silent: wheels told to stop");
  was_heard_ = heard;
  tell_position(now);
  keep_still(now);
  tell_what_is_awaited(now);
}

void Bridge::keep_still(Time now) {
  const bool may = may_move(now);
  if (moved_ && !may && wished_ && now - *wished_ > config_.command_timeout) {
    note(Weight::kWarning,
         "no command for " + std::to_string(config_.command_timeout / 1ms) + " ms: wheels stopped");
  }
  if (!may && moved_) link_.brake();
  if (!may && now >= stop_due_) link_.stop();
  if (!may && (moved_ || now >= stop_due_)) stop_due_ = now + kStopAgain;
  moved_ = may;
}

void Bridge::tell_position(Time now) {
  const bool has = fusion_.has_position(now);
  if (has == had_position_) return;
  had_position_ = has;
  note(has ? Weight::kInfo : Weight::kWarning,
       has ? "position known" : "position lost (GPS): wheels stopped");
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
  await(fusion_.pose(now).has_value(), "its position");
  await(wished_ && now - *wished_ <= config_.command_timeout, "the agent's commands");
  note(Weight::kInfo, "wheels at rest, waiting for: " + awaited);
}

Time Bridge::next_deadline(Time now) const {
  Time next = now + kStopAgain;
  if (const auto link = link_.next_deadline()) next = std::min(next, *link);
  if (moved_) {
    next = std::min(next, *wished_ + config_.command_timeout + 1ns);
    next = std::min(next, fusion_.loses_position_at(now) + 1ns);
  }
  if (was_heard_) next = std::min(next, link_.silent_at());
  return next;
}

Bridge::Effects Bridge::take_effects() {
  effects_.to_robot = link_.take_output();
  effects_.reopen_robot = link_.take_reopen();
  for (Notice& notice : link_.take_notices()) effects_.notices.push_back(std::move(notice));
  return std::exchange(effects_, {});
}

}  // namespace caravan::bridge
