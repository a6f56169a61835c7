// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot_agent/core/path/path.hpp"
#include "robot_agent/core/path/settings.hpp"

namespace caravan::agent {

/// Records the path of an exploring robot, from the source.
///
/// Adds a vertex every RecordingSettings::spacing_m, and where the robot turned sharply: the polyline follows
/// what it drove. Nothing is removed while it explores.
class Recording {
 public:
  Recording(const Point& source, const RecordingSettings& settings);

  /// Adds the robot's pose.
  void visit(const Point& p_WB, double yaw_WB_rad);
  /// The whole path, closed by the destination as its last vertex.
  [[nodiscard]] Path finished_at(const Point& p_WB, const Point& destination) const;
  [[nodiscard]] const Path& so_far() const { return path_; }

 private:
  Path path_;
  RecordingSettings settings_;
  bool started_ = false;
  double last_yaw_WB_rad_ = 0.0;  // at the last vertex
};

/// The path without its loops: where it crosses itself, the section in between is removed. Both branches were
/// driven up to the crossing, so the rest of the path has been driven.
[[nodiscard]] Path without_loops(const Path& path);

}  // namespace caravan::agent
