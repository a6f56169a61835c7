// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/nmea/sentence.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace caravan::bridge::nmea {
namespace {

constexpr double kKnot_mps = 1852.0 / 3600.0;
constexpr double kMostKnots = 2000.0;
constexpr double kMostHdop = 100.0;

unsigned checksum(std::string_view text) {
  unsigned sum = 0;
  for (const char c : text) sum ^= static_cast<unsigned char>(c);
  return sum;
}

/// The text between "$" and "*hh", if the checksum is right.
std::optional<std::string> checked(std::string_view line) {
  const std::size_t star = line.rfind('*');
  if (star == std::string_view::npos || star < 1 || line.size() != star + 3) return std::nullopt;
  unsigned told = 0;
  const auto [end, error] = std::from_chars(line.data() + star + 1, line.data() + line.size(), told, 16);
  if (error != std::errc{} || end != line.data() + line.size()) return std::nullopt;
  const std::string_view inside = line.substr(1, star - 1);
  if (checksum(inside) != told) return std::nullopt;
  return std::string{inside};
}

std::vector<std::string_view> fields_of(std::string_view sentence) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t comma = sentence.find(',');
    fields.push_back(sentence.substr(0, comma));
    if (comma == std::string_view::npos) return fields;
    sentence.remove_prefix(comma + 1);
  }
}

/// A decimal number that fills the field.
std::optional<double> number(std::string_view field) {
  double value = 0.0;
  const auto [end, error] =
      std::from_chars(field.data(), field.data() + field.size(), value, std::chars_format::fixed);
  if (field.empty() || error != std::errc{} || end != field.data() + field.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

/// An integer from 0 to `most` that fills the field.
std::optional<unsigned> count(std::string_view field, unsigned most) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (field.empty() || error != std::errc{} || end != field.data() + field.size() || value > most) {
    return std::nullopt;
  }
  return value;
}

/// An empty field leaves the value unchanged. False: the field is not a number in the range.
template <typename Value>
bool read_optional(std::string_view field, Value& value, double least, double most) {
  if (field.empty()) return true;
  const auto given = number(field);
  if (!given || *given < least || *given > most) return false;
  value = *given;
  return true;
}

/// hhmmss.sss
std::optional<double> time_of_day(std::string_view field) {
  const auto value = number(field);
  if (!value || *value < 0.0 || *value >= 240000.0) return std::nullopt;
  const double hours = std::floor(*value / 10000.0);
  const double minutes = std::floor((*value - 10000.0 * hours) / 100.0);
  const double rest_s = *value - 10000.0 * hours - 100.0 * minutes;
  if (minutes >= 60.0 || rest_s >= 61.0) return std::nullopt;  // 60: a leap second
  return 3600.0 * hours + 60.0 * minutes + rest_s;
}

/// (d)ddmm.mmmm with its hemisphere.
std::optional<double> angle(std::string_view field, std::string_view side, char positive, char negative,
                            double most_deg) {
  const auto value = number(field);
  if (!value || *value < 0.0 || side.size() != 1 || (side[0] != positive && side[0] != negative)) {
    return std::nullopt;
  }
  const double degrees = std::floor(*value / 100.0);
  const double minutes = *value - 100.0 * degrees;
  const double result = degrees + minutes / 60.0;
  if (minutes >= 60.0 || result > most_deg) return std::nullopt;
  return side[0] == positive ? result : -result;
}

struct Place {
  double latitude_deg, longitude_deg;
};
std::optional<Place> place(const std::vector<std::string_view>& fields, std::size_t at) {
  const auto latitude = angle(fields[at], fields[at + 1], 'N', 'S', 90.0);
  const auto longitude = angle(fields[at + 2], fields[at + 3], 'E', 'W', 180.0);
  if (!latitude || !longitude) return std::nullopt;
  return Place{*latitude, *longitude};
}

std::optional<Gga> parse_gga(const std::vector<std::string_view>& fields) {
  if (fields.size() < 9) return std::nullopt;
  const auto quality = count(fields[6], 9);
  if (!quality) return std::nullopt;
  Gga gga;
  gga.quality = *quality;
  const auto time = time_of_day(fields[1]);
  if (gga.quality == 0) {
    gga.time_of_day_s = time.value_or(0.0);
    return gga;
  }
  const auto satellites = count(fields[7], 99);
  const auto where = place(fields, 2);
  if (!time || !where || !satellites || !read_optional(fields[8], gga.hdop, 0.0, kMostHdop)) {
    return std::nullopt;
  }
  gga.time_of_day_s = *time;
  gga.satellites = *satellites;
  gga.latitude_deg = where->latitude_deg;
  gga.longitude_deg = where->longitude_deg;
  return gga;
}

std::optional<Rmc> parse_rmc(const std::vector<std::string_view>& fields) {
  if (fields.size() < 10) return std::nullopt;
  Rmc rmc;
  const auto time = time_of_day(fields[1]);
  rmc.time_of_day_s = time.value_or(0.0);
  rmc.valid = fields[2] == "A";
  if (!rmc.valid) return rmc;
  const auto where = place(fields, 3);
  double knots = 0.0;
  double course_deg = -1.0;
  if (!time || !where || !read_optional(fields[7], knots, 0.0, kMostKnots) ||
      !read_optional(fields[8], course_deg, 0.0, 360.0)) {
    return std::nullopt;
  }
  rmc.latitude_deg = where->latitude_deg;
  rmc.longitude_deg = where->longitude_deg;
  rmc.speed_mps = kKnot_mps * knots;
  if (course_deg >= 0.0) rmc.course_deg = course_deg;
  return rmc;
}

std::string finished(const std::string& sentence) {
  std::array<char, 8> end{};
  std::snprintf(end.data(), end.size(), "*%02X\r\n", checksum(sentence));
  return "$" + sentence + end.data();
}

std::string in_minutes(double degrees, int width, char positive, char negative) {
  const double size = std::abs(degrees);
  double whole = std::floor(size);
  double minutes = std::round((size - whole) * 60.0 * 1e7) / 1e7;
  if (minutes >= 60.0) {
    minutes = 0.0;
    whole += 1.0;
  }
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%0*.0f%010.7f,%c", width, whole, minutes,
                degrees < 0.0 ? negative : positive);
  return text.data();
}

std::string clock_text(double time_of_day_s) {
  const double centis = std::fmod(std::floor(time_of_day_s * 100.0 + 0.5), 8640000.0);
  const double hours = std::floor(centis / 360000.0);
  const double minutes = std::floor((centis - 360000.0 * hours) / 6000.0);
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%02.0f%02.0f%05.2f", hours, minutes,
                (centis - 360000.0 * hours - 6000.0 * minutes) / 100.0);
  return text.data();
}

std::string place_text(double latitude_deg, double longitude_deg) {
  return in_minutes(latitude_deg, 2, 'N', 'S') + "," + in_minutes(longitude_deg, 3, 'E', 'W');
}

}  // namespace

std::vector<std::string> SentenceFinder::feed(std::span<const std::uint8_t> bytes) {
  std::vector<std::string> found;
  for (const std::uint8_t byte : bytes) {
    const char c = static_cast<char>(byte);
    if (c == '$') {
      if (!line_.empty()) ++refused_;
      line_ = c;
    } else if (line_.empty()) {
      continue;
    } else if (c == '\r' || c == '\n') {
      auto sentence = checked(line_);
      if (sentence) found.push_back(std::move(*sentence));
      if (!sentence) ++refused_;
      line_.clear();
    } else if (line_.size() >= kLongest) {
      ++refused_;
      line_.clear();
    } else {
      line_ += c;
    }
  }
  return found;
}

std::optional<std::variant<Gga, Rmc, Other>> parse(std::string_view sentence) {
  const auto fields = fields_of(sentence);
  const std::string_view head = fields.front();
  const std::string_view kind = head.size() == 5 ? head.substr(2) : std::string_view{};
  if (kind == "GGA") {
    if (const auto gga = parse_gga(fields)) return *gga;
    return std::nullopt;
  }
  if (kind == "RMC") {
    if (const auto rmc = parse_rmc(fields)) return *rmc;
    return std::nullopt;
  }
  return Other{};
}

std::string to_line(const Gga& gga) {
  std::array<char, 64> rest{};
  std::array<char, 16> hdop{};
  if (gga.hdop) std::snprintf(hdop.data(), hdop.size(), "%.1f", *gga.hdop);
  std::snprintf(rest.data(), rest.size(), ",%u,%02u,%s,0.0,M,0.0,M,,", gga.quality, gga.satellites,
                hdop.data());
  const std::string where = gga.quality == 0 ? ",,," : place_text(gga.latitude_deg, gga.longitude_deg);
  return finished("GPGGA," + clock_text(gga.time_of_day_s) + "," + where + rest.data());
}

std::string to_line(const Rmc& rmc) {
  std::array<char, 64> rest{};
  if (rmc.course_deg) {
    std::snprintf(rest.data(), rest.size(), ",%.3f,%.2f,010126,,", rmc.speed_mps / kKnot_mps,
                  *rmc.course_deg);
  } else {
    std::snprintf(rest.data(), rest.size(), ",%.3f,,010126,,", rmc.speed_mps / kKnot_mps);
  }
  const std::string where = rmc.valid ? place_text(rmc.latitude_deg, rmc.longitude_deg) : ",,,";
  return finished("GPRMC," + clock_text(rmc.time_of_day_s) + (rmc.valid ? ",A," : ",V,") + where +
                  rest.data());
}

}  // namespace caravan::bridge::nmea
