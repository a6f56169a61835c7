// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hardware_bridge/core/values.hpp"

namespace caravan::bridge {

/// Detects missing frames from the body of an emulated robot. Reports after a second, then once a minute.
class BodyWatch {
 public:
  enum class News : std::uint8_t {
    kNoBody,  ///< no frame has ever arrived
    kSilent   ///< frames no longer arrive
  };

  void heard(Time now) {
    heard_ = true;
    due_ = now + kPatience;
  }
  /// What to report now; none: nothing.
  [[nodiscard]] std::optional<News> look(Time now) {
    if (now < due_) return std::nullopt;
    due_ = now + kAgain;
    return heard_ ? News::kSilent : News::kNoBody;
  }
  [[nodiscard]] Time next_look() const { return due_; }

 private:
  static constexpr Time kPatience = std::chrono::seconds{1};
  static constexpr Time kAgain = std::chrono::minutes{1};
  bool heard_ = false;
  Time due_ = kPatience;
};

}  // namespace caravan::bridge
