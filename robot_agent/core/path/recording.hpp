// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/path/path.hpp"
#include "robot_agent/core/path/settings.hpp"

namespace caravan::agent {

/// The path that an exploring robot leaves behind it: the source, where it started, then where it came.
///
/// A vertex every RecordingSettings::spacing_m, and one where the robot turned sharply, so that the polyline
/// is what it drove. Nothing is removed while it explores.
class Recording {
 public:
  Recording(const Point& source, const RecordingSettings& settings);

  /// The robot is here now, heading in W.
  void visit(const Point& p_WB, double yaw_WB_rad);
  /// The whole path with its last vertex where the destination is.
  [[nodiscard]] Path finished_at(const Point& p_WB, const Point& destination) const;
  [[nodiscard]] const Path& so_far() const { return path_; }

 private:
  Path path_;
  RecordingSettings settings_;
  bool started_ = false;
  double last_yaw_WB_rad_ = 0.0;  // at the last vertex
};

/// The same path without its loops: where it crosses itself the part in between is cut out. Both branches
/// were driven up to the crossing, so what is left was driven, too.
[[nodiscard]] Path without_loops(const Path& path);

}  // namespace caravan::agent
