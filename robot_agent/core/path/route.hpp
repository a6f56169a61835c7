// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "robot_agent/core/path/smoothing.hpp"

namespace caravan::agent {

/// The path of a robot in transport mode, and how far it has come on it.
///
/// `driven` holds only what has been driven, by this robot or by one that gave it: the path that is given to
/// others. `plan` is what the robot follows, in the order of travel: the driven path, but for shortcuts that
/// are still provisional. Their old sections live on in `driven` until the new ones have been driven.
class Route {
 public:
  /// @param driven from the source to the destination, at least two vertices
  Route(const PathFollowing& following, Path driven, bool towards_destination, const Point& p_WB);

  [[nodiscard]] const Path& driven() const { return driven_; }
  [[nodiscard]] const Path& plan() const { return plan_; }
  [[nodiscard]] bool towards_destination() const { return towards_destination_; }
  [[nodiscard]] const Point& end() const { return plan_.back(); }
  [[nodiscard]] bool is_provisional() const { return provisional_.has_value(); }
  /// How far the robot has come on shortcuts that are provisional; 0 when there are none.
  [[nodiscard]] double provisional_m() const;
  /// False while the robot is on its way back to the path, and after a blocked shortcut until the old section
  /// lies behind it: whatever goes wrong, it comes forward.
  [[nodiscard]] bool may_shorten() const { return back_.empty() && next_ > keeps_until_; }
  [[nodiscard]] Ahead ahead() const { return {plan_, to_end_m_, next_}; }
  /// Distance of the robot from the section that it drives on.
  [[nodiscard]] double off_path_m(const Point& p_WB) const;
  /// Way still to go to the end.
  [[nodiscard]] double remaining_m(const Point& p_WB) const;

  /// The robot is here now. @return true when it has driven a provisional shortcut to its end
  bool advance(const Point& p_WB);
  /// Where to steer: the look-ahead point, or the next point of the way back.
  [[nodiscard]] Point goal(const Point& p_WB) const;

  /// Takes a shortcut from where the robot is, provisionally.
  void shorten(const Point& p_WB, std::size_t candidate, double spacing_m, double merge_m);
  /// Leads the plan ahead round places that are in its way, provisionally. @return true when one is
  bool bend_round(std::span<const Point> places, double clear_m, const Point& p_WB);
  struct Ends {
    Point from, to;
  };
  /// Gives the provisional shortcut up and brings the old section back. The robot returns on what it drove.
  /// @return its latest shortcut, that which was blocked. @pre is_provisional()
  Ends restore(const Point& p_WB);
  /// Drops what is provisional and picks the path up where it is nearest: the robot has wandered.
  void rejoin(const Point& p_WB);
  /// At an end: a shortcut that leads there counts as driven, loops go, and the way leads back.
  void turn_round(const Point& p_WB);
  /// A better path with the same ends: adopted; the robot stays on the old one until it meets the new.
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
  std::size_t keeps_until_ = 0;  // vertex of the plan up to which no shortcut is taken
  std::vector<Point> back_;  // points to pass before the plan is picked up at next_; the last one is first
};

}  // namespace caravan::agent
