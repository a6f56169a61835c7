// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/pose/fix_gate.hpp"

#include <array>
#include <cstdio>
#include <utility>

namespace caravan::bridge {
namespace {

constexpr double kMostHdop = 5.0;
constexpr unsigned kFewestSatellites = 4;  // with three the height is undetermined

}  // namespace

std::string complaint(const nmea::Gga& gga) {
  switch (gga.quality) {
    case 0:
      return "no fix";
    case 6:
      return "an estimated position (quality 6) is no fix";
    case 7:
      return "a manual position (quality 7) is no fix";
    case 8:
      return "a simulated position (quality 8) is no fix";
    default:
      break;
  }
  if (gga.satellites >= kFewestSatellites && gga.hdop && *gga.hdop <= kMostHdop) return "";
  std::array<char, 16> hdop{"no HDOP"};
  if (gga.hdop) std::snprintf(hdop.data(), hdop.size(), "HDOP %.1f", *gga.hdop);
  std::array<char, 120> text{};
  std::snprintf(text.data(), text.size(),
                "fix too poor: %u satellites, %s; needs at least %u, HDOP at most %.1f", gga.satellites,
                hdop.data(), kFewestSatellites, kMostHdop);
  return text.data();
}

FixGate::Verdict FixGate::judge(const Point& fix_W, const Point& expected_W) {
  const Point error{fix_W.x_m - expected_W.x_m, fix_W.y_m - expected_W.y_m};
  const bool near = std::hypot(error.x_m, error.y_m) <= jump_m_;
  if (trusting_ && near) return Verdict::kTaken;
  const bool continues =
      row_ && std::hypot(error.x_m - row_->error_W.x_m, error.y_m - row_->error_W.y_m) <= jump_m_;
  if (!continues) row_ = Row{error, 0};
  if (++row_->length >= kAgreeing) {
    trusting_ = true;
    row_.reset();
    return near ? Verdict::kTaken : Verdict::kTakenAnew;
  }
  return std::exchange(trusting_, false) ? Verdict::kOutlier : Verdict::kDoubted;
}

}  // namespace caravan::bridge
