// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "runtime/bus/bus.hpp"
#include "world_server/types.hpp"

namespace caravan::world {

/// The observers that must lose nothing, and how far each has come.
class Credits {
 public:
  /// @param awaited observers without which the run does not start
  explicit Credits(const std::vector<std::string>& awaited) : awaited_{awaited.begin(), awaited.end()} {}

  void give(const std::string& observer, const runtime::ParticipantId& from, Time handled) {
    handled_[observer] = {from, handled};
  }
  void lose(const runtime::ParticipantId& participant) {
    std::erase_if(handled_, [&](const auto& entry) { return entry.second.from == participant; });
  }
  /// Names among the awaited that have not spoken.
  [[nodiscard]] std::vector<std::string> missing() const {
    std::vector<std::string> names;
    for (const std::string& name : awaited_) {
      if (!handled_.contains(name)) names.push_back(name);
    }
    return names;
  }
  /// The observer that keeps the world from a step at `now`, if one does.
  [[nodiscard]] std::optional<std::string> holding_back(Time now, Time furthest_ahead) const {
    for (const auto& [name, entry] : handled_) {
      if (now - entry.handled > furthest_ahead) return name;
    }
    return std::nullopt;
  }

 private:
  struct Entry {
    runtime::ParticipantId from;
    Time handled{0};
  };
  std::set<std::string> awaited_;
  std::map<std::string, Entry> handled_;
};

}  // namespace caravan::world
