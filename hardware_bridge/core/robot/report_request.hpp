// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "hardware_bridge/core/arcos/command.hpp"

namespace caravan::bridge {

/// Whether a report is sent with the next SIP: never, once, or with each SIP.
class ReportRequest {
 public:
  void ask(int argument) {
    wish_ = argument == arcos::kNoReport    ? Wish::kNone
            : argument == arcos::kOneReport ? Wish::kOne
                                            : Wish::kEach;
  }
  /// Whether the report is due. Call once per SIP.
  [[nodiscard]] bool take() {
    const bool due = wish_ != Wish::kNone;
    if (wish_ == Wish::kOne) wish_ = Wish::kNone;
    return due;
  }

 private:
  enum class Wish : std::uint8_t { kNone, kOne, kEach };
  Wish wish_ = Wish::kNone;
};

}  // namespace caravan::bridge
