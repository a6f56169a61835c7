// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/robot/gps_receiver.hpp"

#include "hardware_bridge/core/nmea/sentence.hpp"

namespace caravan::bridge {
namespace {

constexpr double kCourseAbove_mps = 0.1;
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr unsigned kWithFix = 1;
constexpr unsigned kSatellites = 10;
constexpr double kHdop = 0.9;

}  // namespace

Point antenna_place(const Pose& robot, const Point& antenna_B) {
  const double cosine = std::cos(robot.yaw_WB_rad);
  const double sine = std::sin(robot.yaw_WB_rad);
  return {robot.p_WB.x_m + cosine * antenna_B.x_m - sine * antenna_B.y_m,
          robot.p_WB.y_m + sine * antenna_B.x_m + cosine * antenna_B.y_m};
}

void GpsReceiver::sense(const Point& antenna_W, Time measured) {
  sensed_.reset();
  if (std::isfinite(antenna_W.x_m) && std::isfinite(antenna_W.y_m)) sensed_ = Sensed{antenna_W, measured};
}

std::string GpsReceiver::take_lines(Time now) {
  if (now < due_) return "";
  due_ += period_ * ((now - due_) / period_ + 1);
  nmea::Gga gga;
  nmea::Rmc rmc;
  gga.time_of_day_s = rmc.time_of_day_s = std::fmod(seconds(now), 86400.0);
  if (sensed_) {
    const auto place = projection_.to_earth(sensed_->antenna_W);
    gga.latitude_deg = rmc.latitude_deg = place.latitude_deg;
    gga.longitude_deg = rmc.longitude_deg = place.longitude_deg;
    gga.quality = kWithFix;
    gga.satellites = kSatellites;
    gga.hdop = kHdop;
    rmc.valid = true;
  }
  if (sensed_ && told_ && sensed_->at > told_->at) {
    const double dx = sensed_->antenna_W.x_m - told_->antenna_W.x_m;
    const double dy = sensed_->antenna_W.y_m - told_->antenna_W.y_m;
    rmc.speed_mps = std::hypot(dx, dy) / seconds(sensed_->at - told_->at);
    if (rmc.speed_mps > kCourseAbove_mps) {
      rmc.course_deg = projection_.bearing_of_yaw(std::atan2(dy, dx)) / kDegree;
    }
  }
  told_ = sensed_;
  return nmea::to_line(gga) + nmea::to_line(rmc);
}

}  // namespace caravan::bridge
