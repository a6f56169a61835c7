// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <utility>

#include "runtime/bus/bus.hpp"

namespace caravan::runtime {

/// Decides which of two processes with one role for one robot, such as two agents or two bridges, stays.
///
/// The one that started earlier stays; on different hosts, whose clocks may differ, it has to be earlier by
/// more than a second. If they started together, the one already in use stays, else the one with the lower
/// GUID. The other sends nothing, for any of its robots, gives the first
/// one its lease and half a second to vanish (it may have been killed a moment ago), then ends.
///
/// Only one of our processes that is discovered soon after the start makes this process yield. A process that
/// is discovered later started later, whatever it states. For a writer of another make, its reader knows
/// which one was first.
class Clash {
 public:
  using Wall = std::chrono::steady_clock::time_point;

  struct Holder {
    std::uint32_t robot = 0;
    Identity identity;
  };

  /// @param lease_s  lease of this process; that of the other may be as long
  /// @param began    time from which others could discover this process
  Clash(ParticipantId own, Identity own_identity, double lease_s, Wall began)
      : own_{own},
        own_identity_{std::move(own_identity)},
        patience_{static_cast<std::int64_t>((lease_s + 0.5) * 1e9)},
        began_{began} {}

  /// Another writer of a topic that this process writes for the robot was discovered.
  /// @param in_use  the topic's reader has already answered this process
  /// @return true when this process yields
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
  /// Time until which to wait for the other to vanish.
  [[nodiscard]] std::optional<Wall> deadline() const {
    return senior_.empty() ? std::nullopt : std::optional{deadline_};
  }
  /// One of the holders, with its robot, once the deadline is over.
  [[nodiscard]] std::optional<Holder> lost_to(Wall now) const {
    if (senior_.empty() || now < deadline_) return std::nullopt;
    return senior_.begin()->second;
  }

 private:
  [[nodiscard]] bool yields_to(const ParticipantId& other, const Identity& identity, bool in_use) const {
    const std::uint64_t together_ms = identity.host == own_identity_.host ? 0 : 1000;
    const auto role = stated_role(identity);
    if (!role || role != stated_role(own_identity_)) return false;
    if (identity.started_ms + together_ms < own_identity_.started_ms) return true;
    if (own_identity_.started_ms + together_ms < identity.started_ms) return false;
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
