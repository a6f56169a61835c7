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

/// What a GPS receiver's bytes say of the robot's position: fixes that may be believed, and the loss of them.
/// Whatever is refused is told by its reason, and once when no fix has come 10 s after the line was up.
class GpsSource {
 public:
  GpsSource(const ArenaPlace& arena, double jump_m) : projection_{arena}, gate_{jump_m} {}

  struct Fix {
    Point antenna_W;
    bool anew = false;  ///< the position begins anew there
  };
  /// Position is no longer known.
  struct Lost {};
  using News = std::variant<Fix, Lost>;

  /// @param expected_W  see FixGate::judge
  [[nodiscard]] std::vector<News> feed(std::span<const std::uint8_t> bytes, const Point& expected_W,
                                       Time now);
  /// To be called now and then, while there is a line.
  void tick(Time now);
  /// The line is another one now, and so may be the receiver's time.
  void restart() {
    sentences_.restart();
    up_.reset();
    last_time_of_day_s_.reset();
    shortest_way_s_.reset();
  }

  /// Between two fixes that were new, the shortest of the last few; none before there were enough.
  [[nodiscard]] std::optional<Time> period() const;
  [[nodiscard]] std::vector<Notice> take_notices();

 private:
  void hear(const nmea::Gga& gga, const Point& expected_W, Time now, std::vector<News>& news);
  void hear(const nmea::Rmc& rmc, std::vector<News>& news);
  [[nodiscard]] bool is_new(const nmea::Gga& gga, Time now);
  [[nodiscard]] Time age(const nmea::Gga& gga, Time now);
  /// What is wrong with a place; empty: nothing.
  [[nodiscard]] std::string complaint_about(const Point& fix_W) const;
  void tell_of_line(std::size_t bytes, bool understood);
  void warn(std::string text) { notices_.push_back({Notice::Weight::kWarning, "GPS: " + std::move(text)}); }

  ArenaProjection projection_;
  FixGate gate_;
  nmea::SentenceFinder sentences_;
  std::optional<double> last_time_of_day_s_;
  unsigned repeats_ = 0;                  // of that time
  std::optional<double> shortest_way_s_;  // host time less UTC, of the fix that came quickest
  std::optional<Time> last_new_;
  std::deque<Time> periods_;
  unsigned without_gga_ = 0;        // RMCs since the last one
  std::size_t not_understood_ = 0;  // bytes since the last sentence
  std::optional<Time> up_;          // since when there is a line
  bool awaits_first_fix_ = true;    // and has not told so
  bool has_bytes_ = false;          // what has come so far
  bool has_sentence_ = false;
  bool has_place_ = false;   // GGA or RMC
  bool has_no_fix_ = false;  // the receiver says so
  std::vector<Notice> notices_;
};

}  // namespace caravan::bridge
