// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "robot_agent/core/path/smoothing.hpp"

namespace caravan::agent {

/// The path of a robot in transport mode, and its progress on the path.
///
/// `driven` contains only what has been driven, by this robot or by the one that gave it; it is what other
/// robots receive. `plan` is what the robot follows, in the order of travel: the driven path, with shortcuts
/// that are still provisional. `driven` keeps the old sections until the new ones have been driven.
class Route {
 public:
  /// @param driven from the source to the destination, at least two vertices
  Route(const PathFollowing& following, Path driven, bool towards_destination, const Point& p_WB);

  [[nodiscard]] const Path& driven() const { return driven_; }
  [[nodiscard]] const Path& plan() const { return plan_; }
  [[nodiscard]] bool towards_destination() const { return towards_destination_; }
  [[nodiscard]] const Point& end() const { return plan_.back(); }
  [[nodiscard]] bool is_provisional() const { return provisional_.has_value(); }
  /// Distance driven on provisional shortcuts; 0 without one.
  [[nodiscard]] double provisional_m() const;
  /// False while the robot returns to the path. After a blocked shortcut also until it has passed the old
  /// section: this guarantees progress.
  [[nodiscard]] bool may_shorten() const { return back_.empty() && next_ > keeps_until_; }
  [[nodiscard]] Ahead ahead() const { return {plan_, to_end_m_, next_}; }
  /// Distance of the robot from the current segment of the plan.
  [[nodiscard]] double off_path_m(const Point& p_WB) const;
  /// Distance still to drive to the end.
  [[nodiscard]] double remaining_m(const Point& p_WB) const;

  /// Updates the progress. @return true when a provisional shortcut has been driven to its end
  bool advance(const Point& p_WB);
  /// The point to steer to: the look-ahead point, or the next point of the way back.
  [[nodiscard]] Point goal(const Point& p_WB) const;

  /// Takes a shortcut from the robot's position to a candidate, provisionally.
  void shorten(const Point& p_WB, std::size_t candidate, double spacing_m, double merge_m);
  /// Bends the plan ahead round places in its way, provisionally. @return true when it was bent
  bool bend_round(std::span<const Point> places, double clear_m, const Point& p_WB);
  struct Ends {
    Point from, to;
  };
  /// Abandons the provisional shortcut and restores the old section. The robot returns along what it drove of
  /// the shortcut.
  /// @return the latest shortcut, which was blocked. @pre is_provisional()
  Ends restore(const Point& p_WB);
  /// Discards what is provisional and joins the path at its nearest point, after exploration.
  void rejoin(const Point& p_WB);
  /// At an end of the path: confirms a shortcut that leads there, removes loops, and reverses direction.
  void turn_round(const Point& p_WB);
  /// Adopts a better path with the same ends. The robot follows the old one until it meets the new one.
  void replace(Path driven, const Point& p_WB);

 private:
  struct Provisional {
    std::size_t first = 0;  // vertices of the plan
    std::size_t last = 0;
    Ends latest;
  };
  void plan_from_driven();
  void measure();
  void confirm();
  void pick_up(const Point& p_WB);
  PathFollowing following_;
  Path driven_;
  Path plan_;
  std::vector<double> to_end_m_;
  bool towards_destination_;
  std::size_t next_ = 1;
  std::optional<Provisional> provisional_;
  std::size_t keeps_until_ = 0;  // no shortcut is taken up to this vertex of the plan
  std::vector<Point> back_;      // points to pass before the plan continues at next_; last one first
};

}  // namespace caravan::agent
