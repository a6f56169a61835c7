// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <map>
#include <optional>

#include "runtime/bus/bus.hpp"

namespace caravan::agent {

/// Two processes on one robot's topics: who stays.
///
/// The one that started earlier by more than a second stays; of two that started together the one that has
/// answered its world already, else the lower GUID. The other keeps silent, with all of its robots, and gives
/// the first one its lease and half a second to vanish (it may have been killed a moment ago), then ends.
///
/// Only one of our agents that is found soon after the start makes this process give way. Whoever comes later
/// came later, whatever it states; and for a writer of another make it is the reader of the commands that
/// knows who came first.
class Clash {
 public:
  using Wall = std::chrono::steady_clock::time_point;

  struct Holder {
    std::uint32_t robot = 0;
    runtime::Identity identity;
  };

  /// @param began  when this process could be found by others
  Clash(runtime::ParticipantId own, runtime::Identity own_identity, std::chrono::nanoseconds patience,
        Wall began)
      : own_{own}, own_identity_{std::move(own_identity)}, patience_{patience}, began_{began} {}

  /// Another writer of the robot's commands was found. @param has_answered  this process its world, before
  /// @return true when this process gives way
  bool found(std::uint32_t robot, const runtime::ParticipantId& other, const runtime::Identity& identity,
             bool has_answered, Wall now) {
    if (now - began_ > patience_ || !yields_to(other, identity, has_answered)) return false;
    if (senior_.empty()) deadline_ = now + patience_;
    senior_.try_emplace(other, Holder{robot, identity});
    return true;
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
  [[nodiscard]] bool yields_to(const runtime::ParticipantId& other, const runtime::Identity& identity,
                               bool has_answered) const {
    constexpr std::uint64_t kTogetherMs = 1000;
    if (runtime::stated_role(identity) != idl::Party::kAgent) return false;
    if (identity.started_ms + kTogetherMs < own_identity_.started_ms) return true;
    if (own_identity_.started_ms + kTogetherMs < identity.started_ms) return false;
    return !has_answered && other < own_;
  }

  runtime::ParticipantId own_;
  runtime::Identity own_identity_;
  std::chrono::nanoseconds patience_;
  Wall began_;
  std::map<runtime::ParticipantId, Holder> senior_;
  Wall deadline_{};
};

}  // namespace caravan::agent
