// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/pose/pose_fusion.hpp"

namespace caravan::bridge {
namespace {

constexpr double kWayForYaw_m = 0.5;
constexpr double kYawTrust = 0.5;  // in a direction between two fixes

Point operator-(const Point& a, const Point& b) { return {a.x_m - b.x_m, a.y_m - b.y_m}; }
double length(const Point& p) { return std::hypot(p.x_m, p.y_m); }
double direction(const Point& p) { return std::atan2(p.y_m, p.x_m); }

}  // namespace

PoseFusion::PoseFusion(const FusionConfig& config)
    : config_{config},
      pose_{config.start},
      yaw_known_{!config.has_compass},
      placed_{!config.has_gps},
      reckoned_W_{config.start.p_WB} {}

Point PoseFusion::to_W(const Point& p_B) const {
  const double c = std::cos(pose_.yaw_WB_rad);
  const double s = std::sin(pose_.yaw_WB_rad);
  return {c * p_B.x_m - s * p_B.y_m, s * p_B.x_m + c * p_B.y_m};
}

void PoseFusion::move(const arcos::Moved& moved) {
  const double half_way = pose_.yaw_WB_rad + 0.5 * moved.turned_rad;
  for (Point* point : {&pose_.p_WB, &reckoned_W_}) {
    point->x_m += moved.ahead_m * std::cos(half_way);
    point->y_m += moved.ahead_m * std::sin(half_way);
  }
  pose_.yaw_WB_rad = wrapped(pose_.yaw_WB_rad + moved.turned_rad);
}

void PoseFusion::read_compass(double yaw_rad) {
  const double share = yaw_known_ ? config_.compass_trust : 1.0;
  pose_.yaw_WB_rad = wrapped(pose_.yaw_WB_rad + share * wrapped(yaw_rad - pose_.yaw_WB_rad));
  yaw_known_ = true;
}

Point PoseFusion::antenna_W() const {
  const Point from_base = to_W(config_.antenna_B);
  return {pose_.p_WB.x_m + from_base.x_m, pose_.p_WB.y_m + from_base.y_m};
}

void PoseFusion::fix(const Point& antenna_W, Time now, bool anew) {
  const Point base_W = antenna_W - to_W(config_.antenna_B);
  const Point error = base_W - pose_.p_WB;
  const double share = placed_ && !anew ? config_.gps_trust : 1.0;
  if (anew) anchor_.reset();
  pose_.p_WB.x_m += share * error.x_m;
  pose_.p_WB.y_m += share * error.y_m;
  placed_ = true;
  last_fix_ = now;
  if (!config_.has_compass) learn_yaw_from_way(base_W);
}

void PoseFusion::learn_yaw_from_way(const Point& base_W) {
  if (!anchor_) anchor_ = Anchor{base_W, reckoned_W_};
  const Point reckoned = reckoned_W_ - anchor_->reckoned_W;
  const Point fixed = base_W - anchor_->fix_W;
  if (length(reckoned) < kWayForYaw_m) return;
  // Lengths that disagree make the direction unusable: the wheels slipped, or the fix jumped.
  if (std::abs(length(fixed) - length(reckoned)) < 0.5 * length(reckoned)) {
    const double error = wrapped(direction(fixed) - direction(reckoned));
    pose_.yaw_WB_rad = wrapped(pose_.yaw_WB_rad + kYawTrust * error);
  }
  anchor_ = Anchor{base_W, reckoned_W_};
}

bool PoseFusion::has_position(Time now) const {
  return !config_.has_gps || (last_fix_ && now - *last_fix_ <= config_.gps_timeout);
}

Time PoseFusion::loses_position_at(Time now) const {
  if (!config_.has_gps) return Time::max() / 2;
  return last_fix_ ? *last_fix_ + config_.gps_timeout : now;
}

std::optional<Pose> PoseFusion::pose(Time now) const {
  if (!placed_ || !yaw_known_ || !has_position(now)) return std::nullopt;
  return pose_;
}

}  // namespace caravan::bridge
