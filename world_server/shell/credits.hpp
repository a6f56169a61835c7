// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "runtime/bus/tenure.hpp"
#include "world_server/barrier/barrier.hpp"
#include "world_server/types.hpp"

namespace caravan::world {

/// The observer that delays the world's next step, and since when.
struct HeldBack {
  std::optional<std::string> by;
  Wall since{};

  void update(std::optional<std::string> observer, Wall now) {
    if (observer && !by) since = now;
    by = std::move(observer);
  }
};

/// The observers that must not miss a step, and the last step that each has handled.
class Credits {
 public:
  /// @param awaited observers without which the run does not start
  explicit Credits(const std::vector<std::string>& awaited) : awaited_{awaited.begin(), awaited.end()} {}

  /// @return false: refused, because another participant has that name, or there are too many observers that
  /// are not awaited
  bool give(const std::string& observer, const runtime::Sender& from, Time handled) {
    if (!entries_.contains(observer) && !is_awaited(observer) && entries_.size() >= kMost) return false;
    Entry& entry = entries_[observer];
    if (entry.who.claim(from) != runtime::Tenure::Standing::kRefused) {
      entry.handled = handled;
      return true;
    }
    entry.who.keep(from, [&entry, handled] { entry.handled = handled; });
    return false;
  }
  void lose(const runtime::ParticipantId& participant) {
    for (auto& [name, entry] : entries_) {
      if (!entry.who.release(participant)) continue;
      entry.handled.reset();
      for (const auto& take : entry.who.hand_over()) take();
    }
    std::erase_if(entries_, [](const auto& one) { return !one.second.who.holder(); });
  }
  /// Stops waiting for the observer until it gives credit again.
  void let_go(const std::string& observer) { entries_.erase(observer); }

  [[nodiscard]] bool is_awaited(const std::string& observer) const { return awaited_.contains(observer); }
  /// Awaited observers that have not given credit yet.
  [[nodiscard]] std::vector<std::string> missing() const {
    std::vector<std::string> names;
    for (const std::string& name : awaited_) {
      if (!entries_.contains(name)) names.push_back(name);
    }
    return names;
  }
  /// The observer that prevents a step at `now`, if there is one.
  [[nodiscard]] std::optional<std::string> holding_back(Time now, Time furthest_ahead) const {
    for (const auto& [name, entry] : entries_) {
      if (entry.handled && now - *entry.handled > furthest_ahead) return name;
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t kMost = 64;
  struct Entry {
    runtime::Tenure who;
    std::optional<Time> handled;
  };
  std::set<std::string> awaited_;
  std::map<std::string, Entry> entries_;  // each with a holder
};

}  // namespace caravan::world
