// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "world_server/config/world_config.hpp"
#include "world_server/sensors/sonar_fan.hpp"
#include "world_server/shapes/neighbours.hpp"
#include "world_server/shapes/reach_map.hpp"
#include "world_server/types.hpp"

namespace caravan::world {

/// The sonars of a whole fleet in a world of upright solids on a floor.
///
/// Each ray ends at the nearest surface, the floor included. It returns an echo if the angle between it and
/// the inward normal of that surface is below reflection_rad. A transducer's range is the nearest echo of its
/// rays within range_m, +inf if there is none, 0 if it is inside something. A robot never detects its own
/// body. Other robots are upright boxes from the floor to body_height_m, unless they are not solid: then no
/// sonar detects them.
class Sonars {
 public:
  explicit Sonars(const WorldConfig& config);

  /// Sets the poses of the robots. Call it before `ranges` whenever they have moved.
  void place(std::span<const Pose> poses);

  /// The ranges of one robot (index from 0), without noise.
  [[nodiscard]] std::array<double, kSonarCount> ranges(std::size_t robot);

 private:
  /// One upright side of a solid; the solid is to the left of it.
  struct Face {
    Point begin;
    Point along;  // unit
    double length = 0.0;
    double height = 0.0;
  };
  struct Disc {
    Point centre;
    double radius = 0.0;
    double height = 0.0;
  };
  /// A face in the frame of one transducer.
  struct FaceAhead {
    Point to;             // its first end
    Point along;          // unit
    double before = 0.0;  // distance of the transducer from its plane
    double length = 0.0;
    double height = 0.0;
  };
  /// Surfaces that one robot may detect.
  struct Nearby {
    std::vector<Face> faces;
    std::vector<Disc> discs;
    std::vector<const Solid*> low;    // whose tops are below the transducers
    std::vector<const Solid*> close;  // which a transducer may be inside
    void clear();
  };
  struct Hit {
    double distance = 0.0;
    double cosine = -1.0;  // between ray and inward normal
  };

  static void add_sides(const Solid& solid, std::vector<Face>& faces, std::vector<Disc>& discs);
  [[nodiscard]] std::array<Point, 4> corners_of(std::size_t robot) const;
  void gather(std::size_t robot);
  void gather_static(Point base);
  void gather_body(std::size_t other, Point base);
  void add_if_visible(const Face& face, Point base);
  void narrow(Point from, Point axis);
  [[nodiscard]] double listen(Point from, Point axis);
  [[nodiscard]] Hit cast(Point from, Ray ray) const;

  runtime::SonarTable sonar_;
  bool robots_echo_;
  Point body_low_;  // the hull in frame B
  Point body_high_;
  double body_radius_ = 0.0;   // of its farthest corner
  double mount_radius_ = 0.0;  // of the farthest transducer
  double body_height_ = 0.0;
  struct Transducer {
    Point place;  // in frame B
    Point axis;   // unit, in frame B
  };
  std::array<Transducer, kSonarCount> transducers_;
  std::vector<Ray> rays_;
  double echo_cosine_;
  bool floor_echoes_ = false;
  Point left_edge_;  // of the cone, in the transducer's frame

  std::vector<Solid> solids_;    // static
  std::vector<Extent> extents_;  // of the solids
  std::vector<Face> faces_;
  std::vector<Disc> discs_;
  std::unique_ptr<ReachMap> map_;  // of solids, then faces, then discs

  std::vector<Point> bases_;     // of the robots
  std::vector<Point> headings_;  // unit
  Neighbours neighbours_;
  // Scratch space for the current robot and transducer.
  std::vector<std::uint32_t> others_;
  std::vector<Solid> bodies_;  // those that are low or close
  Nearby around_;
  std::vector<FaceAhead> faces_ahead_;
  std::vector<Disc> discs_ahead_;
};

}  // namespace caravan::world
