// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/host/notice_limit.hpp"

#include <algorithm>
#include <utility>

namespace caravan::bridge {
namespace {

using namespace std::chrono_literals;

constexpr unsigned kAtOnce = 3;
constexpr Time kPeriod = 30s;
constexpr std::size_t kMostKinds = 256;  // the rest is one

std::string without_numbers(std::string text) {
  std::erase_if(text, [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-'; });
  return text;
}

}  // namespace

std::optional<Notice> NoticeLimit::pass(Notice notice, Time now) {
  // What a device calls itself may be anything.
  std::replace_if(
      notice.text.begin(), notice.text.end(), [](unsigned char c) { return c < 0x20 || c >= 0x7f; }, '?');
  std::string name = without_numbers(notice.text);
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
  return std::nullopt;
}

std::vector<Notice> NoticeLimit::take_due(Time now) {
  std::vector<Notice> due;
  for (auto& [text, kind] : kinds_) {
    if (kind.held_back == 0 || now < kind.due) continue;
    const std::string count =
        " (" + std::to_string(kind.held_back) + " times in " + std::to_string(kPeriod / 1s) + " s)";
    due.push_back({kind.last.weight, kind.last.text + count});
    kind.held_back = 0;
    kind.due = now + kPeriod;
  }
  return due;
}

}  // namespace caravan::bridge
