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

constexpr double kCompassUnit_rad = 2.0 * std::numbers::pi / 180.0;
constexpr std::uint8_t kCompassUnits = 180;
// Above what a Pioneer 3-DX can reach.
constexpr double kTopSpeed_mps = 2.2;
constexpr double kTopTurn_radps = 500.0 / 180.0 * std::numbers::pi;
constexpr Time kJitter = 300ms;  // of the time between two SIPs
constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

std::variant<ArcosGripper, ImaginedGripper> gripper_of(const BridgeConfig& config) {
  if (config.has_gripper) return ArcosGripper{};
  return ImaginedGripper{config.source_W, config.service_radius_m};
}

}  // namespace

Bridge::Bridge(const BridgeConfig& config)
    : config_{config},
      link_{config.link},
      health_{config.low_battery_v},
      gps_{config.arena, config.gps_jump_m},
      projection_{config.arena},
      fusion_{config.fusion},
      gripper_{gripper_of(config)},
      had_position_{!config.fusion.has_gps} {}

void Bridge::robot_up(Time now) {
  odometry_.reset();
  followed_.reset();
  sonars_.forget();
  sonar_watch_.restart();
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

bool Bridge::know_scale() {
  if (odometry_) return true;
  const std::string& subtype = link_.names()->subtype;
  const auto factors = config_.position_count_m ? arcos::Factors{.position_m = *config_.position_count_m}
                                                : arcos::factors_of(subtype);
  if (!factors) {
    effects_.unfit = "robot subtype " + subtype +
                     ": the scale of its odometry is not known; set bridge.position_count_m in the scenario";
    return false;
  }
  odometry_.emplace(*factors);
  return true;
}

void Bridge::on_sip(const arcos::Sip& sip, Time now) {
  if (!know_scale()) return;
  for (Notice& notice : health_.watch(sip)) effects_.notices.push_back(std::move(notice));
  for (Notice& notice : sonar_watch_.watch(sip.sonars, now)) effects_.notices.push_back(std::move(notice));
  see_stop(sip);
  tell_of_missing_commands();
  follow(sip, now);
  if (auto* gripper = std::get_if<ArcosGripper>(&gripper_)) {
    if (const auto again = gripper->see(sip, now)) link_.send(*again);
  }
  publish(now);
}

void Bridge::see_stop(const arcos::Sip& sip) {
  const bool motors_on = (sip.flags & arcos::kMotorsOn) != 0;
  switch (latch_.see((sip.flags & arcos::kStopPressed) != 0, motors_on)) {
    case StopLatch::Change::kPressed:
      note(Weight::kWarning, "emergency stop pressed: wheels stopped");
      break;
    case StopLatch::Change::kReleased:
      note(Weight::kWarning,
           "emergency stop released: the robot stands until somebody presses its MOTORS button");
      break;
    case StopLatch::Change::kRestarted:
      note(Weight::kInfo, "restarted at the MOTORS button after the emergency stop");
      break;
    case StopLatch::Change::kNone:
      break;
  }
  link_.keep_motors_off(latch_.is_on());
  if (latch_.wants_motors_off() && motors_on) link_.send(arcos::encode(arcos::Order::kEnable, 0));
}

arcos::Moved Bridge::plausible(const arcos::Moved& moved, Time now) {
  const double passed_s = seconds(kJitter + (followed_ ? now - *followed_ : Time{0}));
  followed_ = now;
  if (std::abs(moved.ahead_m) <= kTopSpeed_mps * passed_s &&
      std::abs(moved.turned_rad) <= kTopTurn_radps * passed_s) {
    return moved;
  }
  note(Weight::kWarning, "odometry jumped by " + std::to_string(std::lround(100.0 * moved.ahead_m)) +
                             " cm from one packet to the next: ignored");
  return {};
}

void Bridge::follow(const arcos::Sip& sip, Time now) {
  const arcos::Moved moved = plausible(odometry_->follow(sip), now);
  const double half_turn_m = 0.5 * moved.turned_rad * config_.track_m;
  left_wheel_rad_ += (moved.ahead_m - half_turn_m) / config_.wheel_radius_m;
  right_wheel_rad_ += (moved.ahead_m + half_turn_m) / config_.wheel_radius_m;
  fusion_.move(moved);
  if (config_.fusion.has_compass && sip.compass < kCompassUnits) {
    fusion_.read_compass(
        projection_.yaw_of_bearing(kCompassUnit_rad * sip.compass + config_.compass_offset_rad));
  }
  if (config_.fusion.has_compass && sip.compass >= kCompassUnits) {
    note(Weight::kWarning, "compass reading out of its range: ignored");
  }
  sonars_.hear(sip.sonars, now);
}

void Bridge::publish(Time now) {
  Frame frame;
  frame.stamp = last_stamp_ = std::max(now, last_stamp_ + 1us);  // two SIPs may arrive together
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
  for (const GpsSource::News& news : gps_.feed(bytes, fusion_.antenna_W(), now)) {
    std::visit(pure::Overload{[&](const GpsSource::Fix& fix) {
                                if (config_.fusion.has_gps) fusion_.fix(fix.antenna_W, now, fix.anew);
                              },
                              [&](const GpsSource::Lost&) { fusion_.lose_fix(); }},
               news);
  }
  tick(now);
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

Bridge::Effects Bridge::take_effects() {
  effects_.to_robot = link_.take_output();
  effects_.reopen_robot = link_.take_reopen();
  for (Notice& notice : link_.take_notices()) effects_.notices.push_back(std::move(notice));
  return std::exchange(effects_, {});
}

}  // namespace caravan::bridge
