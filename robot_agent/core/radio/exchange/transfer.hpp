// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "robot_agent/core/path/path.hpp"
#include "robot_agent/core/radio/frames/messages.hpp"

namespace caravan::agent {

/// The nearest point that a frame can carry; coordinates beyond 2147 km are cut there.
[[nodiscard]] GridPoint to_grid(const Point& point);
[[nodiscard]] Point from_grid(const GridPoint& point);

/// Two paths crossing in one session, one side of it (docs/protocol.md, section "Exchange").
///
/// Fragments arrive in any order, twice or never. What the partner does not hold yet is sent round and round;
/// each fragment acknowledges how much of the partner's path is here without a gap. Memory is bounded by the
/// largest path that a frame can announce, 65535 points.
class Transfer {
 public:
  /// @param own    the path to give; fewer than 2 or more than 65535 points: none
  /// @param wants  keep the partner's path; false: it is acknowledged whatever it is, and dropped
  /// @param points_per_frame  >= 1
  Transfer(const Path& own, bool wants, std::uint32_t points_per_frame);

  /// Takes in a fragment. One that contradicts what was announced before has no effect.
  void absorb(const PathFragment& fragment);
  /// The next one to send, without its address.
  [[nodiscard]] PathFragment next();

  [[nodiscard]] bool holds_all() const;      ///< the partner's path is here
  [[nodiscard]] bool has_given() const;      ///< the partner acknowledged all of ours
  [[nodiscard]] Path partners_path() const;  ///< empty: it has none, or it is not wanted. @pre holds_all()

 private:
  void announced(std::uint16_t total);

  std::vector<GridPoint> own_;
  std::uint32_t points_per_frame_;
  bool wants_;
  std::size_t cursor_ = 0;        // next own point to send
  std::size_t acknowledged_ = 0;  // own points that the partner holds without a gap
  bool partner_has_heard_ = false;

  bool has_heard_ = false;
  std::uint16_t total_ = 0;  // of the partner's path, once has_heard_
  std::vector<GridPoint> received_;
  std::vector<bool> is_here_;
  std::size_t held_ = 0;
};

}  // namespace caravan::agent
