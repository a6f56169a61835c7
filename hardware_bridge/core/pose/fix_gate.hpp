// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "hardware_bridge/core/nmea/sentence.hpp"
#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// Why a fix is refused by what the receiver reports of it; empty: it is not. Refused are estimated, manual
/// and simulated positions, too few satellites, and too high a dilution of precision.
[[nodiscard]] std::string complaint(const nmea::Gga& gga);

/// Refuses implausible positions.
///
/// A fix is accepted within `jump_m` of the place predicted by odometry from the previous fixes. Another fix
/// puts the position in doubt, as it is at the start. Doubt ends when kAgreeing fixes in a row agree with one
/// another, at the new place or at the predicted one.
///
///   state    | fix near the predicted place            | fix elsewhere
///   ---------+-----------------------------------------+-----------------------------------------
///   trusting | taken                                   | doubting, first of a row; refused
///   doubting | next of its row, or first of a new row; | likewise; the fifth of a row: trusting,
///            | the fifth of a row: trusting, taken     | taken anew
class FixGate {
 public:
  static constexpr unsigned kAgreeing = 5;

  explicit FixGate(double jump_m) : jump_m_{jump_m} {}

  enum class Verdict : std::uint8_t {
    kTaken,
    kTakenAnew,  ///< the position starts anew there
    kOutlier,    ///< the first fix that does not agree
    kDoubted     ///< in doubt: too few fixes agree
  };
  /// @param fix_W       position of the antenna by this fix
  /// @param expected_W  position predicted by odometry from the previous fixes; before the first fix,
  ///                    any point moved by odometry
  [[nodiscard]] Verdict judge(const Point& fix_W, const Point& expected_W);

  /// Puts the position in doubt: the fix was refused for another reason.
  void doubt() {
    trusting_ = false;
    row_.reset();
  }

 private:
  struct Row {
    Point error_W;  // of the row's first fix from the expected place; odometry moves both
    unsigned length = 0;
  };
  double jump_m_;
  bool trusting_ = false;
  std::optional<Row> row_;
};

}  // namespace caravan::bridge
