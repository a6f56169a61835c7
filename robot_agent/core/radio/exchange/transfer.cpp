// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/radio/exchange/transfer.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/pure/assert.hpp"

namespace caravan::agent {
namespace {

constexpr std::size_t kLongestPath = 65535;
constexpr double kGridPerMetre = 1000.0;
constexpr double kFarthest_mm = 2147483647.0;

std::int32_t to_mm(double coordinate_m) {
  const double mm = std::round(coordinate_m * kGridPerMetre);
  if (std::isnan(mm)) return 0;
  return static_cast<std::int32_t>(std::clamp(mm, -kFarthest_mm, kFarthest_mm));
}

}  // namespace

GridPoint to_grid(const Point& point) { return {to_mm(point.x()), to_mm(point.y())}; }

Point from_grid(const GridPoint& point) {
  return {static_cast<double>(point.x_mm) / kGridPerMetre, static_cast<double>(point.y_mm) / kGridPerMetre};
}

Transfer::Transfer(const Path& own, bool wants, std::uint32_t points_per_frame)
    : points_per_frame_{points_per_frame}, wants_{wants} {
  CARAVAN_ASSERT(points_per_frame_ >= 1);
  if (own.size() < 2 || own.size() > kLongestPath) return;
  own_.reserve(own.size());
  for (const Point& point : own) own_.push_back(to_grid(point));
}

void Transfer::announced(std::uint16_t total) {
  has_heard_ = true;
  total_ = total;
  if (wants_) {
    received_.resize(total);
    is_here_.resize(total);
  } else {
    held_ = total;
  }
}

void Transfer::absorb(const PathFragment& fragment) {
  if (fragment.first + fragment.points.size() > fragment.total) return;
  if (!has_heard_) announced(fragment.total);
  if (fragment.total != total_) return;
  partner_has_heard_ = partner_has_heard_ || fragment.has_heard;
  if (fragment.holds <= own_.size()) acknowledged_ = std::max<std::size_t>(acknowledged_, fragment.holds);
  if (!wants_) return;
  for (std::size_t index = 0; index < fragment.points.size(); ++index) {
    const std::size_t place = fragment.first + index;
    if (is_here_[place]) continue;
    is_here_[place] = true;
    received_[place] = fragment.points[index];
  }
  while (held_ < total_ && is_here_[held_]) ++held_;
}

PathFragment Transfer::next() {
  PathFragment fragment;
  fragment.total = static_cast<std::uint16_t>(own_.size());
  fragment.has_heard = has_heard_;
  fragment.holds = static_cast<std::uint16_t>(held_);
  if (cursor_ < acknowledged_ || cursor_ >= own_.size()) cursor_ = acknowledged_;
  const std::size_t end = std::min<std::size_t>(cursor_ + points_per_frame_, own_.size());
  fragment.first = static_cast<std::uint16_t>(cursor_);
  fragment.points.assign(own_.begin() + static_cast<std::ptrdiff_t>(cursor_),
                         own_.begin() + static_cast<std::ptrdiff_t>(end));
  cursor_ = end;
  return fragment;
}

bool Transfer::holds_all() const { return has_heard_ && held_ == total_; }

bool Transfer::has_given() const { return partner_has_heard_ && acknowledged_ == own_.size(); }

Path Transfer::partners_path() const {
  CARAVAN_ASSERT(holds_all());
  Path path;
  path.reserve(received_.size());
  for (const GridPoint& point : received_) path.push_back(from_grid(point));
  return path;
}

}  // namespace caravan::agent
