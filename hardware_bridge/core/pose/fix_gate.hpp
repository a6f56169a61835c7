// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "hardware_bridge/core/nmea/sentence.hpp"
#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// What is wrong with what the receiver says of its fix; empty: nothing. A fix that was estimated, typed in
/// or simulated is none, nor is one with too few satellites or too bad a geometry.
[[nodiscard]] std::string complaint(const nmea::Gga& gga);

/// Refuses positions that cannot be true.
///
/// A fix is believed when it lies within `jump_m` of where odometry has carried the robot from the fixes
/// before. One that does not puts the position in doubt. Doubt ends when so many fixes in a row agree with
/// one another, there or at the old place; so does that of the beginning.
///
///   state    | fix near the expected place | fix elsewhere
///   ---------+-----------------------------+------------------------------------------------
///   trusting | taken                       | doubting, the first of a row; refused
///   doubting | next of its row, or the first of another; with the fifth: trusting, taken anew
class FixGate {
 public:
  static constexpr unsigned kAgreeing = 5;

  explicit FixGate(double jump_m) : jump_m_{jump_m} {}

  enum class Verdict : std::uint8_t {
    kTaken,
    kTakenAnew,  ///< the position begins anew there
    kOutlier,    ///< the first one that does not agree
    kDoubted     ///< not yet enough that agree
  };
  /// @param fix_W       where the antenna is by this fix
  /// @param expected_W  where it should be by the fixes before and odometry; before the first, any point that
  ///                    odometry carries
  [[nodiscard]] Verdict judge(const Point& fix_W, const Point& expected_W);

  /// A fix was no fix at all: the next ones must agree first.
  void doubt() {
    trusting_ = false;
    row_.reset();
  }

 private:
  struct Row {
    Point error_W;  // of its first fix from the expected place: odometry moves both
    unsigned length = 0;
  };
  double jump_m_;
  bool trusting_ = false;
  std::optional<Row> row_;
};

}  // namespace caravan::bridge
