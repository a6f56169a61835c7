// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/host/notice_limit.hpp"

#include <algorithm>
#include <utility>

namespace caravan::bridge {
namespace {

using namespace std::chrono_literals;

constexpr unsigned kAtOnce = 3;
constexpr Time kPeriod = 30s;
constexpr Time kLasts = 5s;              // time after which a state counts as lasting
constexpr std::size_t kMostKinds = 256;  // further kinds share one entry

std::string without_numbers(std::string text) {
  std::erase_if(text, [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-'; });
  return text;
}

}  // namespace

std::optional<Notice> NoticeLimit::pass(Notice notice, Time now) {
  // Names from a device may contain any bytes.
  std::replace_if(
      notice.text.begin(), notice.text.end(), [](unsigned char c) { return c < 0x20 || c >= 0x7f; }, '?');
  std::string name = without_numbers(notice.about.empty() ? notice.text : notice.about);
  if (kinds_.size() >= kMostKinds && !kinds_.contains(name)) name.clear();
  Kind& kind = kinds_[name];
  if (kind.held_back == 0 && now >= kind.due) kind.passed = 0;
  if (kind.held_back == 0) kind.due = now + kPeriod;
  if (kind.passed < kAtOnce) {
    ++kind.passed;
    return notice;
  }
  ++kind.held_back;
  kind.last = std::move(notice);
  kind.changed = now;
  return std::nullopt;
}

std::vector<Notice> NoticeLimit::take_due(Time now) {
  std::vector<Notice> due;
  for (auto& [text, kind] : kinds_) {
    const bool is_state = !kind.last.about.empty();
    const bool lasts = is_state && now >= kind.changed + kLasts;
    if (kind.held_back == 0 || (now < kind.due && !lasts)) continue;
    const std::string count = std::to_string(kind.held_back);
    due.push_back(
        {kind.last.weight, kind.last.text + (is_state ? " (" + count + " changes since the last line of it)"
                                                      : " (" + count + " times in the last 30 s)")});
    kind.held_back = 0;
    kind.due = now + kPeriod;
  }
  return due;
}

}  // namespace caravan::bridge
