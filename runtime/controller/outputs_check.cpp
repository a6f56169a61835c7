// SPDX-License-Identifier: Apache-2.0
#include "runtime/controller/outputs_check.hpp"

#include <cmath>
#include <cstdio>
#include <string_view>

#include "runtime/controller/snake_case.hpp"
#include "runtime/pure/one_line.hpp"

namespace caravan::runtime {
namespace {

std::string short_text(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", number);
  return text;
}

std::string element(const char* list, std::size_t index) {
  return "report." + std::string{list} + "[" + std::to_string(index) + "]";
}

std::string too_many(const char* list, std::size_t count, std::size_t most) {
  if (count <= most) return "";
  return std::string{list} + " has " + std::to_string(count) + " elements, more than " + std::to_string(most);
}

template <typename Enumeration>
std::string none_of_them(const char* name, Enumeration value, Enumeration last) {
  if (value <= last) return "";
  return std::string{name} + " = " + std::to_string(static_cast<unsigned>(value)) +
         " is none of its enumeration";
}

/// Well-formed UTF-8 (RFC 3629) without NUL, at which other programs would cut it off.
bool is_text(std::string_view bytes) {
  std::size_t rest = 0;  // bytes of the character that are to come
  unsigned lowest = 0x80;
  unsigned highest = 0xbf;
  for (const char one : bytes) {
    const unsigned byte = static_cast<unsigned char>(one);
    if (rest > 0) {
      if (byte < lowest || byte > highest) return false;
      lowest = 0x80;
      highest = 0xbf;
      --rest;
    } else if (byte >= 0xc2 && byte <= 0xdf) {
      rest = 1;
    } else if (byte >= 0xe0 && byte <= 0xef) {
      rest = 2;
      if (byte == 0xe0) lowest = 0xa0;
      if (byte == 0xed) highest = 0x9f;
    } else if (byte >= 0xf0 && byte <= 0xf4) {
      rest = 3;
      if (byte == 0xf0) lowest = 0x90;
      if (byte == 0xf4) highest = 0x8f;
    } else if (byte == 0 || byte >= 0x80) {
      return false;
    }
  }
  return rest == 0;
}

std::string fault_in(const std::vector<Frame>& frames) {
  if (auto fault = too_many("frames", frames.size(), kMostFrames); !fault.empty()) return fault;
  std::size_t bytes = 0;
  for (const Frame& frame : frames) bytes += frame.bytes.size();
  if (bytes <= kMostFrameBytes) return "";
  return "frames have " + std::to_string(bytes) + " bytes together, more than " +
         std::to_string(kMostFrameBytes);
}

std::string fault_in(const std::vector<Position>& path) {
  if (auto fault = too_many("report.path", path.size(), kMostPathPoints); !fault.empty()) return fault;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto [x_m, y_m] = path[i];
    if (std::abs(x_m) <= kFarthest_m && std::abs(y_m) <= kFarthest_m) continue;  // false for NaN
    return element("path", i) + " = (" + short_text(x_m) + ", " + short_text(y_m) + ") is not within " +
           short_text(kFarthest_m) + " m of zero";
  }
  return "";
}

std::string fault_in(const std::vector<Exchange>& exchanges, Time now) {
  if (auto fault = too_many("report.exchanges", exchanges.size(), kMostExchanges); !fault.empty())
    return fault;
  for (std::size_t i = 0; i < exchanges.size(); ++i) {
    const Exchange& one = exchanges[i];
    if (one.began >= Time{0} && one.began <= one.ended && one.ended <= now) continue;
    return element("exchanges", i) + " began at " + std::to_string(one.began.count()) + " ns and ended at " +
           std::to_string(one.ended.count()) + " ns, must begin from 0 on, end later, and not after now";
  }
  return "";
}

std::string fault_in(const std::vector<Event>& events) {
  if (auto fault = too_many("report.events", events.size(), kMostEvents); !fault.empty()) return fault;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const std::size_t bytes = events[i].name.size() + events[i].detail.size();
    if (bytes > kMostEventBytes)
      return element("events", i) + " has " + std::to_string(bytes) + " bytes, more than " +
             std::to_string(kMostEventBytes);
    if (!is_lower_snake_case(events[i].name))
      return "the name of an event, \"" + pure::one_line(events[i].name) + "\", is not in lower_snake_case";
    if (!is_text(events[i].detail)) return element("events", i) + ".detail is not UTF-8 without NUL";
  }
  return "";
}

std::string fault_in(const Report& report, Time now) {
  std::string fault = none_of_them("report.mode", report.mode, Mode::kTransport);
  if (fault.empty()) fault = none_of_them("report.activity", report.activity, Activity::kExchanging);
  if (fault.empty()) fault = none_of_them("report.origin", report.origin, Origin::kReceived);
  if (fault.empty() && report.path) fault = fault_in(*report.path);
  if (fault.empty()) fault = fault_in(report.exchanges, now);
  if (fault.empty()) fault = fault_in(report.events);
  return fault;
}

}  // namespace

std::string fault_in(const Outputs& outputs, Time now) {
  if (!std::isfinite(outputs.left_mps) || !std::isfinite(outputs.right_mps))
    return "wheel speeds " + std::to_string(outputs.left_mps) + " and " + std::to_string(outputs.right_mps) +
           " m/s are not finite";
  std::string fault = fault_in(outputs.frames);
  if (fault.empty() && outputs.report) fault = fault_in(*outputs.report, now);
  return fault;
}

}  // namespace caravan::runtime
