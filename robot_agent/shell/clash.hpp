// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <map>
#include <optional>

#include "runtime/bus/bus.hpp"

namespace caravan::agent {

/// Two processes on one robot's topics: who stays.
///
/// The one that started earlier by more than a second stays; of two that started together the lower GUID. The
/// other keeps silent, with all of its robots, and gives the first one its lease and half a second to vanish
/// (it may have been killed a moment ago), then ends.
class Clash {
 public:
  using Wall = std::chrono::steady_clock::time_point;

  struct Holder {
    std::uint32_t robot = 0;
    runtime::Identity identity;
  };

  Clash(runtime::ParticipantId own, runtime::Identity own_identity, std::chrono::nanoseconds patience)
      : own_{own}, own_identity_{std::move(own_identity)}, patience_{patience} {}

  /// Another writer of the robot's commands was found.
  void found(std::uint32_t robot, const runtime::ParticipantId& other, const runtime::Identity& identity,
             Wall now) {
    if (!yields_to(other, identity)) return;
    if (senior_.empty()) deadline_ = now + patience_;
    senior_.try_emplace(other, Holder{robot, identity});
  }
  void vanished(const runtime::ParticipantId& other) { senior_.erase(other); }

  /// While true, send nothing.
  [[nodiscard]] bool must_be_silent() const { return !senior_.empty(); }
  /// Until when to wait for the other to vanish.
  [[nodiscard]] std::optional<Wall> deadline() const {
    return senior_.empty() ? std::nullopt : std::optional{deadline_};
  }
  /// Who holds which robot: one of them. @pre must_be_silent()
  [[nodiscard]] const Holder& holder() const { return senior_.begin()->second; }

 private:
  [[nodiscard]] bool yields_to(const runtime::ParticipantId& other, const runtime::Identity& identity) const {
    constexpr std::uint64_t kTogetherMs = 1000;
    if (identity.started_ms + kTogetherMs < own_identity_.started_ms) return true;
    if (own_identity_.started_ms + kTogetherMs < identity.started_ms) return false;
    return other < own_;
  }

  runtime::ParticipantId own_;
  runtime::Identity own_identity_;
  std::chrono::nanoseconds patience_;
  std::map<runtime::ParticipantId, Holder> senior_;
  Wall deadline_{};
};

}  // namespace caravan::agent
