// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/types.hpp"

/// The paper's three communication modes (section 4), the independent variable of its experiment.
namespace caravan::agent {

enum class Sharing : std::uint8_t {
  kNone,     ///< no robot pairs
  kPartial,  ///< a robot with a path gives it to a robot without one, and accepts none
  kFull      ///< a robot accepts every path, and merges it with its own
};

/// Whether the mode lets two robots pair, by whether they have paths. Two robots without a path have nothing
/// to exchange.
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

/// Whether a robot accepts the path of its partner.
[[nodiscard]] constexpr bool wants_path(Sharing sharing, Mode own) {
  return sharing == Sharing::kFull || (sharing == Sharing::kPartial && own == Mode::kExplore);
}

}  // namespace caravan::agent
