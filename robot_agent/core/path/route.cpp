// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/path/route.hpp"

#include <algorithm>

#include "robot_agent/core/path/bending.hpp"
#include "robot_agent/core/path/following.hpp"
#include "robot_agent/core/path/intersections.hpp"
#include "robot_agent/core/path/recording.hpp"
#include "runtime/pure/assert.hpp"

namespace caravan::agent {
namespace {

constexpr double kSamePoint_m = kTouch_m;  // as in merge()

}  // namespace

Route::Route(const PathFollowing& following, Path driven, bool towards_destination, const Point& p_WB)
    : following_{following}, driven_{std::move(driven)}, towards_destination_{towards_destination} {
  CARAVAN_ASSERT(driven_.size() >= 2);
  plan_from_driven();
  next_ = nearest_location(plan_, p_WB);
}

void Route::plan_from_driven() {
  plan_ = driven_;
  if (!towards_destination_) std::reverse(plan_.begin(), plan_.end());
  provisional_.reset();
  back_.clear();
  keeps_until_ = 0;
  measure();
}

void Route::measure() {
  to_end_m_.assign(plan_.size(), 0.0);
  for (std::size_t i = plan_.size() - 1; i > 0; --i) {
    to_end_m_[i - 1] = to_end_m_[i] + (plan_[i] - plan_[i - 1]).norm();
  }
}

void Route::confirm() {
  driven_ = plan_;
  if (!towards_destination_) std::reverse(driven_.begin(), driven_.end());
  provisional_.reset();
}

double Route::off_path_m(const Point& p_WB) const {
  return project(std::span{plan_}.subspan(next_ - 1, 2), p_WB).distance_m;
}

double Route::remaining_m(const Point& p_WB) const {
  double sum = to_end_m_[next_];
  Point from = p_WB;
  for (std::size_t i = back_.size(); i-- > 0;) {
    sum += (back_[i] - from).norm();
    from = back_[i];
  }
  return sum + (plan_[next_] - from).norm();
}

bool Route::advance(const Point& p_WB) {
  if (!back_.empty()) {
    if ((back_.back() - p_WB).norm() < following_.return_reached_m) back_.pop_back();
    pick_up(p_WB);
    return false;
  }
  next_ = next_location(plan_, next_, p_WB, following_);
  if (!provisional_ || next_ <= provisional_->last) return false;
  confirm();
  return true;
}

void Route::pick_up(const Point& p_WB) {
  if (keeps_until_ < next_) return;
  const Projection near = project(std::span{plan_}.subspan(next_ - 1, keeps_until_ - next_ + 2), p_WB);
  if (near.distance_m > following_.pick_up_m) return;
  back_.clear();
  next_ += near.segment;
}

double Route::provisional_m() const {
  return provisional_ ? std::max(0.0, to_end_m_[provisional_->first] - to_end_m_[next_]) : 0.0;
}

Point Route::goal(const Point& p_WB) const {
  return back_.empty() ? look_ahead_point(plan_, next_, p_WB, following_) : back_.back();
}

void Route::shorten(const Point& p_WB, std::size_t candidate, double spacing_m, double merge_m) {
  CARAVAN_ASSERT(back_.empty());
  const Point to = plan_[candidate];
  const std::size_t old_size = plan_.size();
  Shortened shortened = with_shortcut(ahead(), p_WB, candidate, spacing_m, merge_m);
  Provisional now{shortened.next - 1, shortened.last, {p_WB, to}};
  if (provisional_) {
    now.first = std::min(now.first, provisional_->first);
    if (provisional_->last > candidate) now.last = shortened.path.size() - (old_size - provisional_->last);
  }
  plan_ = std::move(shortened.path);
  next_ = shortened.next;
  provisional_ = now;
  measure();
}

bool Route::bend_round(std::span<const Point> places, double clear_m, const Point& p_WB) {
  if (!may_shorten()) return false;
  std::optional<Bend> bend = bent_round(plan_, next_ - 1, places, clear_m);
  if (!bend) return false;
  const std::size_t old_size = plan_.size();
  const std::size_t old_last = bend->last + old_size - bend->path.size();
  Provisional now{bend->first, bend->last, {plan_[bend->first], plan_[old_last]}};
  if (provisional_) {
    now.first = std::min(now.first, provisional_->first);
    if (provisional_->last > old_last) now.last = bend->path.size() - (old_size - provisional_->last);
  }
  if (bend->first < next_) {
    const std::span section = std::span{bend->path}.subspan(bend->first, bend->last - bend->first + 1);
    next_ = bend->first + project(section, p_WB).segment + 1;
  }
  plan_ = std::move(bend->path);
  provisional_ = now;
  measure();
  return true;
}

Route::Ends Route::restore(const Point& p_WB) {
  CARAVAN_ASSERT(provisional_.has_value());
  Ends blocked = provisional_->latest;
  // Return along what was driven of the shortcut, to the vertex where it left the old path.
  const auto first = plan_.begin() + static_cast<std::ptrdiff_t>(provisional_->first);
  std::vector<Point> back(
      first, plan_.begin() + static_cast<std::ptrdiff_t>(std::max(next_, provisional_->first + 1)));
  const Point left_at = back.front();
  const Point leads_to = plan_[provisional_->last];
  // `back` is passed from its last element.
  plan_from_driven();
  next_ = nearest_location(plan_, left_at);
  const std::span ahead = std::span{plan_}.subspan(next_ - 1);
  keeps_until_ = next_ + project(ahead, leads_to).segment;
  while (!back.empty() && (back.back() - p_WB).norm() < following_.return_reached_m) back.pop_back();
  back_ = std::move(back);
  return blocked;
}

void Route::rejoin(const Point& p_WB) {
  plan_from_driven();
  next_ = nearest_location(plan_, p_WB);
}

void Route::turn_round(const Point& p_WB) {
  // An end may come near before a shortcut's end does: that shortcut has not been driven.
  if (remaining_m(p_WB) < following_.end_m && back_.empty()) confirm();
  driven_ = without_loops(driven_);
  towards_destination_ = !towards_destination_;
  plan_from_driven();
  next_ = nearest_location(plan_, p_WB);
}

void Route::replace(Path driven, const Point& p_WB) {
  CARAVAN_ASSERT(driven.size() >= 2);
  if (provisional_) restore(p_WB);
  // Follow the old path until it meets the new one; both have the same end.
  std::vector<Point> way(back_.rbegin(), back_.rend());
  const Path old = plan_;
  const std::size_t old_next = next_;
  driven_ = std::move(driven);
  plan_from_driven();
  for (std::size_t i = old_next; i < old.size(); ++i) {
    way.push_back(old[i]);
    if (project(plan_, old[i]).distance_m <= kSamePoint_m) break;
  }
  next_ = nearest_location(plan_, way.back());
  if (project(plan_, p_WB).distance_m <= following_.return_reached_m) {
    next_ = nearest_location(plan_, p_WB);
    way.clear();
  }
  std::reverse(way.begin(), way.end());
  back_ = std::move(way);
}

}  // namespace caravan::agent
