// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "hardware_bridge/core/host/notice.hpp"
#include "hardware_bridge/core/nmea/sentence.hpp"
#include "hardware_bridge/core/pose/arena_projection.hpp"
#include "hardware_bridge/core/pose/fix_gate.hpp"

namespace caravan::bridge {

/// Evaluates the bytes of a GPS receiver: credible fixes, and the loss of the position. Reports the reason of
/// each refusal, and once if there is no fix within 10 s.
class GpsSource {
 public:
  GpsSource(const ArenaPlace& arena, double jump_m) : projection_{arena}, gate_{jump_m} {}

  struct Fix {
    Point antenna_W;
    bool anew = false;  ///< the position starts anew there
  };
  /// The position is no longer known.
  struct Lost {};
  using News = std::variant<Fix, Lost>;

  /// @param expected_W  see FixGate::judge
  [[nodiscard]] std::vector<News> feed(std::span<const std::uint8_t> bytes, const Point& expected_W,
                                       Time now);
  /// Call regularly while the line is up.
  void tick(Time now);
  /// A new connection: the receiver's clock may differ.
  void restart() {
    sentences_.restart();
    up_.reset();
    last_time_of_day_s_.reset();
    shortest_way_s_.reset();
  }

  /// Shortest time between two new fixes among the last few; none before there are enough.
  [[nodiscard]] std::optional<Time> period() const;
  [[nodiscard]] std::vector<Notice> take_notices();

 private:
  void hear(const nmea::Gga& gga, const Point& expected_W, Time now, std::vector<News>& news);
  void hear(const nmea::Rmc& rmc, std::vector<News>& news);
  [[nodiscard]] bool is_new(const nmea::Gga& gga, Time now);
  [[nodiscard]] Time age(const nmea::Gga& gga, Time now);
  /// The fault of a position; empty: none.
  [[nodiscard]] std::string complaint_about(const Point& fix_W) const;
  void tell_of_line(std::size_t bytes, bool understood);
  void warn(std::string text) { notices_.push_back({Notice::Weight::kWarning, "GPS: " + std::move(text)}); }

  ArenaProjection projection_;
  FixGate gate_;
  nmea::SentenceFinder sentences_;
  std::optional<double> last_time_of_day_s_;
  unsigned repeats_ = 0;                  // number of fixes with that time
  std::optional<double> shortest_way_s_;  // host time minus UTC of the quickest fix
  std::optional<Time> last_new_;
  std::deque<Time> periods_;
  unsigned without_gga_ = 0;        // RMCs since the last GGA
  std::size_t not_understood_ = 0;  // bytes since the last sentence
  std::optional<Time> up_;          // when the line came up
  bool awaits_first_fix_ = true;    // and has not reported it
  bool has_bytes_ = false;          // whether anything has arrived so far
  bool has_sentence_ = false;
  bool has_place_ = false;   // GGA or RMC
  bool has_no_fix_ = false;  // reported by the receiver
  std::vector<Notice> notices_;
};

}  // namespace caravan::bridge
