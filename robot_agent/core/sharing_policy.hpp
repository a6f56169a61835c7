// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/types.hpp"

/// What the paper's three communication modes (section 4) permit: the one variable of its experiment.
namespace caravan::agent {

enum class Sharing : std::uint8_t {
  kNone,     ///< nobody pairs
  kPartial,  ///< a robot with a path gives it to one without; it takes none itself
  kFull      ///< a robot takes a path each time, and merges it with its own
};

/// May two robots pair, going by what they have? Two without a path have nothing to give.
[[nodiscard]] constexpr bool may_pair(Sharing sharing, Mode own, Mode partner) {
  const bool one_has_a_path = own == Mode::kTransport || partner == Mode::kTransport;
  const bool one_has_none = own == Mode::kExplore || partner == Mode::kExplore;
  switch (sharing) {
    case Sharing::kNone:
      return false;
    case Sharing::kPartial:
      return one_has_a_path && one_has_none;
    case Sharing::kFull:
      return one_has_a_path;
  }
  return false;
}

/// Does a robot want the path that a partner gives?
[[nodiscard]] constexpr bool wants_path(Sharing sharing, Mode own) {
  return sharing == Sharing::kFull || (sharing == Sharing::kPartial && own == Mode::kExplore);
}

}  // namespace caravan::agent
