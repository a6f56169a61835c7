// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "robot_agent/core/path/path.hpp"
#include "robot_agent/core/radio/frames/messages.hpp"

namespace caravan::agent {

/// The nearest point that a frame can carry. Coordinates are limited to 2147 km; NaN becomes 0.
[[nodiscard]] GridPoint to_grid(const Point& point);
[[nodiscard]] Point from_grid(const GridPoint& point);

/// The exchange of two paths in one session, as seen by one partner (docs/protocol.md, section "Exchange").
///
/// Fragments may be lost, reordered or duplicated. Points that the partner does not hold yet are sent in a
/// loop. Each fragment acknowledges how many points of the partner's path are held without a gap. Memory is
/// bounded by the longest path that a frame can announce, 65535 points.
class Transfer {
 public:
  /// @param own    the path to give; with fewer than 2 or more than 65535 points none is given
  /// @param wants  whether to keep the partner's path; false: acknowledges all of it and discards it
  /// @param points_per_frame  >= 1
  Transfer(const Path& own, bool wants, std::uint32_t points_per_frame);

  /// Handles a fragment. A fragment that contradicts the announced length has no effect.
  void absorb(const PathFragment& fragment);
  /// The next fragment to send, without its address.
  [[nodiscard]] PathFragment next();

  [[nodiscard]] bool holds_all() const;      ///< the partner's path is complete here
  [[nodiscard]] bool has_given() const;      ///< the partner has acknowledged all of ours
  [[nodiscard]] Path partners_path() const;  ///< empty: it has none, or it is discarded. @pre holds_all()

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
