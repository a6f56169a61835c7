// SPDX-License-Identifier: Apache-2.0
#include "world_server/sensors/sonar.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace caravan::world {
namespace {

constexpr double kRounding = 1e-6;
constexpr double kNoEcho = std::numeric_limits<double>::infinity();

/// Distance of the farthest transducer from the base.
double mount_radius() {
  double radius = 0.0;
  for (const robot_model::SonarMount& mount : robot_model::kSonarMounts)
    radius = std::max(radius, length({mount.x_m, mount.y_m}));
  return radius;
}

Point turned(Point a, Point by) { return {a.x * by.x - a.y * by.y, a.x * by.y + a.y * by.x}; }

bool is_within(const Extent& extent, Point place, double reach) {
  return place.x >= extent.low.x - reach && place.x <= extent.high.x + reach &&
         place.y >= extent.low.y - reach && place.y <= extent.high.y + reach;
}

std::vector<Solid> solids_of(const WorldConfig& config) {
  std::vector<Solid> solids;
  for (const Box& wall : arena_walls(config.arena_m, config.wall_height_m)) solids.push_back(to_solid(wall));
  for (const Box& box : config.boxes) solids.push_back(to_solid(box));
  for (const Outline& outline : config.outlines) solids.push_back(to_solid(outline));
  for (const Cylinder& cylinder : config.cylinders) solids.push_back(to_solid(cylinder));
  return solids;
}

}  // namespace

Sonars::Sonars(const WorldConfig& config)
    : sonar_{config.robots.sonar},
      robots_echo_{config.robots.solid},
      body_low_{config.robots.body_ahead_m - config.robots.body_length_m, -0.5 * config.robots.body_width_m},
      body_high_{config.robots.body_ahead_m, 0.5 * config.robots.body_width_m},
      body_height_{config.robots.body_height_m},
      rays_{sonar_rays(config.robots.sonar)},
      echo_cosine_{std::cos(config.robots.sonar.reflection_rad)},
      left_edge_{std::cos(0.5 * sonar_.aperture_rad), std::sin(0.5 * sonar_.aperture_rad)},
      solids_{solids_of(config)} {
  for (const Solid& solid : solids_) add_sides(solid, faces_, discs_);
  for (std::size_t i = 0; i < kSonarCount; ++i) {
    const robot_model::SonarMount& mount = robot_model::kSonarMounts[i];
    transducers_[i] = {{mount.x_m, mount.y_m}, {std::cos(mount.heading_rad), std::sin(mount.heading_rad)}};
  }
  for (const Ray& ray : rays_) floor_echoes_ = floor_echoes_ || -ray.up > echo_cosine_;
  body_radius_ = std::max(length(body_low_), length(body_high_));
  mount_radius_ = mount_radius();
  for (const Solid& solid : solids_) extents_.push_back(extent_of(solid));
  std::vector<Extent> extents = extents_;
  for (const Face& face : faces_) {
    extents.push_back(extent_of({{face.begin, face.begin + face.length * face.along}, {}, 0.0, 0.0}));
  }
  for (const Disc& disc : discs_) extents.push_back(extent_of({{}, disc.centre, disc.radius, 0.0}));
  map_ = std::make_unique<ReachMap>(config.arena_m, extents, sonar_.range_m + mount_radius_);
}

void Sonars::Nearby::clear() {
  faces.clear();
  discs.clear();
  low.clear();
  close.clear();
}

void Sonars::add_sides(const Solid& solid, std::vector<Face>& faces, std::vector<Disc>& discs) {
  if (solid.outline.empty()) {
    discs.push_back({solid.centre, solid.radius, solid.height});
    return;
  }
  for (std::size_t i = 0; i < solid.outline.size(); ++i) {
    const Point begin = solid.outline[i];
    const Point side = solid.outline[(i + 1) % solid.outline.size()] - begin;
    const double side_m = length(side);
    faces.push_back({begin, (1.0 / side_m) * side, side_m, solid.height});
  }
}

/// Corners of a robot's body, counter-clockwise.
std::array<Point, 4> Sonars::corners_of(std::size_t robot) const {
  const Point base = bases_[robot];
  const Point heading = headings_[robot];
  return {placed(body_high_, base, heading.x, heading.y),
          placed({body_low_.x, body_high_.y}, base, heading.x, heading.y),
          placed(body_low_, base, heading.x, heading.y),
          placed({body_high_.x, body_low_.y}, base, heading.x, heading.y)};
}

void Sonars::place(std::span<const Pose> poses) {
  bases_.clear();
  headings_.clear();
  for (const Pose& pose : poses) {
    bases_.push_back({pose.x_m, pose.y_m});
    headings_.push_back({std::cos(pose.yaw_rad), std::sin(pose.yaw_rad)});
  }
  neighbours_.rebuild(bases_, sonar_.range_m + mount_radius_ + body_radius_);
}

void Sonars::gather(std::size_t robot) {
  const Point base = bases_[robot];
  around_.clear();
  bodies_.clear();
  gather_static(base);
  others_.clear();
  if (robots_echo_) neighbours_.near(base, others_);
  bodies_.reserve(others_.size());  // around_ points into it
  for (const std::uint32_t other : others_) {
    if (other != robot) gather_body(other, base);
  }
}

void Sonars::gather_static(Point base) {
  for (const std::uint32_t i : map_->near(base)) {
    if (i < solids_.size()) {
      if (solids_[i].height < kSonarHeight) around_.low.push_back(&solids_[i]);
      if (is_within(extents_[i], base, mount_radius_)) around_.close.push_back(&solids_[i]);
    } else if (i < solids_.size() + faces_.size()) {
      add_if_visible(faces_[i - solids_.size()], base);
    } else {
      around_.discs.push_back(discs_[i - solids_.size() - faces_.size()]);
    }
  }
}

void Sonars::gather_body(std::size_t other, Point base) {
  const std::array<Point, 4> corners = corners_of(other);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point side = corners[(i + 1) % corners.size()] - corners[i];
    const double side_m = length(side);
    add_if_visible({corners[i], (1.0 / side_m) * side, side_m, body_height_}, base);
  }
  const bool is_low = body_height_ < kSonarHeight;
  const bool is_close = length(bases_[other] - base) <= body_radius_ + mount_radius_;
  if (!is_low && !is_close) return;
  const Solid& body = bodies_.emplace_back(Solid{{corners.begin(), corners.end()}, {}, 0.0, body_height_});
  if (is_low) around_.low.push_back(&body);
  if (is_close) around_.close.push_back(&body);
}

/// Skips faces that no transducer of the robot can detect: from behind, or out of range.
void Sonars::add_if_visible(const Face& face, Point base) {
  const Point to = face.begin - base;
  const double before = cross(face.along, to);
  const double reach = sonar_.range_m + mount_radius_ + kRounding;
  if (before < -mount_radius_ - kRounding || before > reach) return;
  const double beside = -dot(to, face.along);
  if (beside < -reach || beside > face.length + reach) return;
  around_.faces.push_back(face);
}

/// Keeps what the cone of a transducer may hit: facing it, in range, and not wholly to one side.
void Sonars::narrow(Point from, Point axis) {
  const Point left = turned(axis, left_edge_);
  const Point right = turned(axis, {left_edge_.x, -left_edge_.y});
  faces_ahead_.clear();
  discs_ahead_.clear();
  for (const Face& face : around_.faces) {
    const Point a = face.begin - from;
    const double before = cross(face.along, a);
    if (before <= 0.0 || before > sonar_.range_m) continue;
    const Point b = a + face.length * face.along;
    if (cross(left, a) > 0.0 && cross(left, b) > 0.0) continue;
    if (cross(right, a) < 0.0 && cross(right, b) < 0.0) continue;
    if (dot(axis, a) < 0.0 && dot(axis, b) < 0.0) continue;
    faces_ahead_.push_back({a, face.along, before, face.length, face.height});
  }
  for (const Disc& disc : around_.discs) {
    const Point centre = disc.centre - from;
    if (cross(left, centre) > disc.radius || cross(right, centre) < -disc.radius) continue;
    if (dot(axis, centre) < -disc.radius || length(centre) > sonar_.range_m + disc.radius) continue;
    discs_ahead_.push_back(disc);
  }
}

Sonars::Hit Sonars::cast(Point from, Ray ray) const {
  Hit hit{.distance = kNoEcho};
  if (ray.up < 0.0) hit = {.distance = kSonarHeight / -ray.up, .cosine = -ray.up};
  for (const FaceAhead& face : faces_ahead_) {
    const double inwards = cross(face.along, ray.flat);
    if (inwards <= 0.0) continue;
    const double distance = face.before / inwards;
    if (distance >= hit.distance || kSonarHeight + distance * ray.up > face.height) continue;
    const double along = dot(distance * ray.flat - face.to, face.along);
    if (along >= 0.0 && along <= face.length) hit = {distance, inwards};
  }
  for (const Disc& disc : discs_ahead_) {
    const Point to = disc.centre - from;
    const double square = dot(ray.flat, ray.flat);
    const double half = dot(to, ray.flat);
    const double root = half * half - square * (dot(to, to) - disc.radius * disc.radius);
    if (root < 0.0) continue;
    const double distance = (half - std::sqrt(root)) / square;
    if (distance < 0.0 || distance >= hit.distance || kSonarHeight + distance * ray.up > disc.height)
      continue;
    hit = {distance, dot(to - distance * ray.flat, ray.flat) / disc.radius};
  }
  if (ray.up >= 0.0) return hit;
  for (const Solid* solid : around_.low) {
    const double distance = (kSonarHeight - solid->height) / -ray.up;
    if (distance < hit.distance && contains(*solid, from + distance * ray.flat)) hit = {distance, -ray.up};
  }
  return hit;
}

double Sonars::listen(Point from, Point axis) {
  for (const Solid* solid : around_.close) {
    if (solid->height >= kSonarHeight && contains(*solid, from)) return 0.0;
  }
  narrow(from, axis);
  if (faces_ahead_.empty() && discs_ahead_.empty() && !floor_echoes_) return kNoEcho;
  double nearest = kNoEcho;
  for (const Ray& ray : rays_) {
    const Hit hit = cast(from, {turned(ray.flat, axis), ray.up});
    if (hit.distance <= sonar_.range_m && hit.cosine > echo_cosine_)
      nearest = std::min(nearest, hit.distance);
  }
  return nearest;
}

std::array<double, kSonarCount> Sonars::ranges(std::size_t robot) {
  gather(robot);
  const Point base = bases_[robot];
  const Point heading = headings_[robot];
  std::array<double, kSonarCount> result{};
  for (std::size_t i = 0; i < kSonarCount; ++i) {
    const Transducer& one = transducers_[i];
    result[i] = listen(placed(one.place, base, heading.x, heading.y), turned(heading, one.axis));
  }
  return result;
}

}  // namespace caravan::world
