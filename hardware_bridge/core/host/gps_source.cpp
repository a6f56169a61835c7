// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/host/gps_source.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "runtime/pure/overload.hpp"

namespace caravan::bridge {
namespace {

/// The projection is accurate within some hundred metres; no arena is larger.
constexpr double kFarthest_m = 1000.0;
constexpr unsigned kRepeatsWorthTelling = 3;
constexpr unsigned kRmcsWorthTelling = 5;
constexpr std::size_t kBytesWorthTelling = 1000;
constexpr std::size_t kPeriods = 4;
constexpr double kDay_s = 86400.0;
constexpr Time kOldest = std::chrono::seconds{1};
constexpr Time kFirstFixPatience = std::chrono::seconds{10};

std::string in_metres(double metres) {
  return metres < 10000.0 ? std::to_string(std::lround(metres)) + " m"
                          : std::to_string(std::lround(0.001 * metres)) + " km";
}

}  // namespace

std::vector<GpsSource::News> GpsSource::feed(std::span<const std::uint8_t> bytes, const Point& expected_W,
                                             Time now) {
  std::vector<News> news;
  const std::uint64_t refused = sentences_.refused();
  const auto sentences = sentences_.feed(bytes);
  for (const std::string& sentence : sentences) {
    const auto parsed = nmea::parse(sentence);
    if (!parsed) warn("sentence refused, a field is missing or out of its range: " + sentence);
    if (!parsed) continue;
    std::visit(pure::Overload{[&](const nmea::Gga& gga) { hear(gga, expected_W, now, news); },
                              [&](const nmea::Rmc& rmc) { hear(rmc, news); }, [](const nmea::Other&) {}},
               *parsed);
  }
  if (sentences_.refused() > refused) warn("sentence with a wrong checksum refused");
  has_bytes_ = has_bytes_ || !bytes.empty();
  has_sentence_ = has_sentence_ || !sentences.empty();
  tell_of_line(bytes.size(), !sentences.empty());
  return news;
}

void GpsSource::tick(Time now) {
  if (!up_) up_ = now;
  if (!awaits_first_fix_ || now - *up_ < kFirstFixPatience) return;
  awaits_first_fix_ = false;
  const std::string so_far = " in the first " + in_seconds(kFirstFixPatience);
  if (!has_bytes_)
    warn("the receiver has sent nothing" + so_far + ": is it switched on, and is --gps its port?");
  if (has_sentence_ && !has_place_)
    warn("the receiver has sent no GGA" + so_far + ": switch it on in the receiver");
  if (has_no_fix_) warn("the receiver has no fix" + so_far + ": does its antenna see the sky?");
}

void GpsSource::tell_of_line(std::size_t bytes, bool understood) {
  not_understood_ = understood ? 0 : not_understood_ + bytes;
  if (not_understood_ < kBytesWorthTelling) return;
  not_understood_ = 0;
  warn("no NMEA sentence in " + std::to_string(kBytesWorthTelling) +
       " bytes: is it a GPS receiver, and is --gps-baud its rate?");
}

bool GpsSource::is_new(const nmea::Gga& gga, Time now) {
  if (last_time_of_day_s_ == gga.time_of_day_s) {
    if (++repeats_ == kRepeatsWorthTelling) warn("the receiver repeats one fix (the same UTC): not counted");
    return false;
  }
  repeats_ = 0;
  if (last_new_) periods_.push_back(now - *last_new_);
  if (periods_.size() > kPeriods) periods_.pop_front();
  last_new_ = now;
  return true;
}

/// Delay relative to the quickest fix. UTC that goes back means that the receiver has set its clock.
Time GpsSource::age(const nmea::Gga& gga, Time now) {
  const double since_last_s =
      last_time_of_day_s_ ? std::remainder(gga.time_of_day_s - *last_time_of_day_s_, kDay_s) : -1.0;
  last_time_of_day_s_ = gga.time_of_day_s;
  const double way_s = std::remainder(seconds(now) - gga.time_of_day_s, kDay_s);
  if (since_last_s < 0.0 || !shortest_way_s_) shortest_way_s_ = way_s;
  const double later_s = std::remainder(way_s - *shortest_way_s_, kDay_s);
  if (later_s < 0.0) shortest_way_s_ = way_s;
  return to_time(std::max(0.0, later_s));
}

std::string GpsSource::complaint_about(const Point& fix_W) const {
  const double from_origin_m = std::hypot(fix_W.x_m, fix_W.y_m);
  if (from_origin_m <= kFarthest_m) return "";
  return "fix " + in_metres(from_origin_m) + " from the arena's origin refused: is bridge.origin_* right?";
}

void GpsSource::hear(const nmea::Gga& gga, const Point& expected_W, Time now, std::vector<News>& news) {
  without_gga_ = 0;
  has_place_ = true;
  std::string wrong = complaint(gga);
  if (wrong.empty() && !is_new(gga, now)) return;
  const Point fix_W = projection_.to_arena(gga.latitude_deg, gga.longitude_deg);
  if (wrong.empty() && age(gga, now) > kOldest) {
    wrong = "fixes arrive more than 1 s late: is its line too slow?";
  } else if (wrong.empty()) {
    wrong = complaint_about(fix_W);
    if (!wrong.empty()) gate_.doubt();
  }
  if (!wrong.empty()) {
    if (gga.quality == 0)
      has_no_fix_ = true;
    else
      warn(wrong);
    news.emplace_back(Lost{});
    return;
  }
  const FixGate::Verdict verdict = gate_.judge(fix_W, expected_W);
  if (verdict == FixGate::Verdict::kTaken || verdict == FixGate::Verdict::kTakenAnew) {
    awaits_first_fix_ = false;
    news.emplace_back(Fix{fix_W, verdict == FixGate::Verdict::kTakenAnew});
    return;
  }
  news.emplace_back(Lost{});
  if (verdict != FixGate::Verdict::kOutlier) return;
  const double off_m = std::hypot(fix_W.x_m - expected_W.x_m, fix_W.y_m - expected_W.y_m);
  warn("fix " + in_metres(off_m) + " from the expected place refused until " +
       std::to_string(FixGate::kAgreeing) + " in a row agree");
}

void GpsSource::hear(const nmea::Rmc& rmc, std::vector<News>& news) {
  has_place_ = true;
  if (!rmc.valid) news.emplace_back(Lost{});  // a position is taken from GGA only
  if (++without_gga_ % kRmcsWorthTelling != 0) return;
  warn("the receiver sends RMC but no GGA, which says how good a fix is: switch GGA on in the receiver");
}

std::optional<Time> GpsSource::period() const {
  if (periods_.size() < kPeriods) return std::nullopt;
  return *std::min_element(periods_.begin(), periods_.end());
}

std::vector<Notice> GpsSource::take_notices() { return std::exchange(notices_, {}); }

}  // namespace caravan::bridge
