// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <caravan/robot.hpp>
#include <cstdint>
#include <numbers>

/// Defaults of the robot, a Pioneer 3-DX, and its radio, where a scenario gives no value: the only definition
/// for world, agent, bridge, radio and tests.
namespace caravan::robot_model {

inline constexpr double kBodyLength_m = 0.485;
inline constexpr double kBodyAhead_m = 0.200;  ///< from the axle to the front
inline constexpr double kBodyWidth_m = 0.381;
inline constexpr double kBodyHeight_m = 0.217;
inline constexpr double kMass_kg = 9.0;
inline constexpr double kTrack_m = 0.330;
inline constexpr double kWheelRadius_m = 0.0975;
inline constexpr double kWheelLimit_mps = 1.6;  ///< rim speed

using caravan::SonarMount;
[[nodiscard]] constexpr SonarMount sonar_mount(double x_mm, double y_mm, double heading_degrees) {
  return {x_mm / 1000.0, y_mm / 1000.0, heading_degrees * std::numbers::pi / 180.0};
}

using caravan::kSonarCount;
/// Two arrays of eight: 0 .. 7 ahead from left to right, 8 .. 15 behind from right to left (ARIA's p3dx.p).
inline constexpr std::array<SonarMount, kSonarCount> kSonarMounts{
    sonar_mount(69, 136, 90),      sonar_mount(114, 119, 50),    sonar_mount(148, 78, 30),
    sonar_mount(166, 27, 10),      sonar_mount(166, -27, -10),   sonar_mount(148, -78, -30),
    sonar_mount(114, -119, -50),   sonar_mount(69, -136, -90),   sonar_mount(-157, -136, -90),
    sonar_mount(-203, -119, -130), sonar_mount(-237, -78, -150), sonar_mount(-255, -27, -170),
    sonar_mount(-255, 27, 170),    sonar_mount(-237, 78, 150),   sonar_mount(-203, 119, 130),
    sonar_mount(-157, 136, 90)};
inline constexpr double kSonarAperture_rad = 0.4;  ///< full cone of each
inline constexpr double kSonarRange_m = 5.0;

inline constexpr double kRadioRange_m = 2.0;
inline constexpr std::uint32_t kChannelCount = 1U << 20U;
inline constexpr std::uint32_t kMtu_bytes = 250;

}  // namespace caravan::robot_model
