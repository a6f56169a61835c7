// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <utility>

#include "runtime/bus/bus.hpp"

namespace caravan::runtime {

/// Two processes of one role for one robot, such as two agents or two bridges: who stays.
///
/// The one that started earlier by more than a second stays; of two that started together the one that is in
/// use already, else the lower GUID. The other keeps silent, with all of its robots, and gives the first one
/// its lease and half a second to vanish (it may have been killed a moment ago), then ends.
///
/// Only one of ours that is found soon after the start makes this process give way. Whoever comes later came
/// later, whatever it states; and for a writer of another make it is the reader that knows who came first.
class Clash {
 public:
  using Wall = std::chrono::steady_clock::time_point;

  struct Holder {
    std::uint32_t robot = 0;
    Identity identity;
  };

  /// @param lease_s  the other's may be as long as this process's
  /// @param began    when this process could be found by others
  Clash(ParticipantId own, Identity own_identity, double lease_s, Wall began)
      : own_{own},
        own_identity_{std::move(own_identity)},
        patience_{static_cast<std::int64_t>((lease_s + 0.5) * 1e9)},
        began_{began} {}

  /// Another writer of what this process writes for the robot was found. @param in_use  its reader has
  /// answered this process, before
  /// @return true when this process gives way
  bool found(std::uint32_t robot, const ParticipantId& other, const Identity& identity, bool in_use,
             Wall now) {
    if (now - began_ > patience_ || !yields_to(other, identity, in_use)) return false;
    if (senior_.empty()) deadline_ = now + patience_;
    senior_.try_emplace(other, Holder{robot, identity});
    return true;
  }
  void vanished(const ParticipantId& other) { senior_.erase(other); }

  /// While true, send nothing.
  [[nodiscard]] bool must_be_silent() const { return !senior_.empty(); }
  /// Until when to wait for the other to vanish.
  [[nodiscard]] std::optional<Wall> deadline() const {
    return senior_.empty() ? std::nullopt : std::optional{deadline_};
  }
  /// Who holds which robot: one of them, once the deadline is over.
  [[nodiscard]] std::optional<Holder> lost_to(Wall now) const {
    if (senior_.empty() || now < deadline_) return std::nullopt;
    return senior_.begin()->second;
  }

 private:
  [[nodiscard]] bool yields_to(const ParticipantId& other, const Identity& identity, bool in_use) const {
    constexpr std::uint64_t kTogetherMs = 1000;
    const auto role = stated_role(identity);
    if (!role || role != stated_role(own_identity_)) return false;
    if (identity.started_ms + kTogetherMs < own_identity_.started_ms) return true;
    if (own_identity_.started_ms + kTogetherMs < identity.started_ms) return false;
    return !in_use && other < own_;
  }

  ParticipantId own_;
  Identity own_identity_;
  std::chrono::nanoseconds patience_;
  Wall began_;
  std::map<ParticipantId, Holder> senior_;
  Wall deadline_{};
};

}  // namespace caravan::runtime
