// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/path/merge.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "robot_agent/core/path/intersections.hpp"

namespace caravan::agent {
namespace {

constexpr std::size_t kMostIntersections = 100000;  // bounds time and memory; real paths have hundreds
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// The best way to some place: its length, and the intersection of its last change of paths.
struct Way {
  double length_m = 0.0;
  std::size_t changed_at = kNone;  // kNone: never
};

/// The best earlier change: prefix minimum over positions along a path, as a Fenwick tree.
class BestChange {
 public:
  explicit BestChange(std::size_t positions) : tree_(positions + 1, Way{kNever, kNone}) {}
  void offer(std::size_t position, Way way) {
    for (std::size_t node = position + 1; node < tree_.size(); node += node & (~node + 1)) {
      if (way.length_m < tree_[node].length_m) tree_[node] = way;
    }
  }
  /// The best at or before `position`.
  [[nodiscard]] Way best(std::size_t position) const {
    Way way{kNever, kNone};
    for (std::size_t node = position + 1; node > 0; node -= node & (~node + 1)) {
      if (tree_[node].length_m < way.length_m) way = tree_[node];
    }
    return way;
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  std::vector<Way> tree_;
};

/// Rank of each intersection along `b`; equal positions share a rank.
std::vector<std::size_t> ranks_on_b(const std::vector<Intersection>& meetings) {
  std::vector<double> arcs;
  arcs.reserve(meetings.size());
  for (const Intersection& meeting : meetings) arcs.push_back(meeting.on_b.arc_m);
  std::sort(arcs.begin(), arcs.end());
  std::vector<std::size_t> ranks;
  ranks.reserve(meetings.size());
  for (const Intersection& meeting : meetings) {
    ranks.push_back(static_cast<std::size_t>(std::lower_bound(arcs.begin(), arcs.end(), meeting.on_b.arc_m) -
                                             arcs.begin()));
  }
  return ranks;
}

/// The changes of paths, in order, and the path to begin on.
struct Plan {
  bool begins_on_a = true;
  std::vector<std::size_t> changes;
};

/// The shortest way along both paths that changes at intersections in the same order along both, by dynamic
/// programming over the intersections. Between two consecutive intersections of a chain it takes the shorter
/// section, as Algorithm 7 does; of all ordered chains it takes the best.
class Planner {
 public:
  Planner(const std::vector<Intersection>& meetings, double length_a_m, double length_b_m)
      : meetings_{meetings}, length_a_m_{length_a_m}, length_b_m_{length_b_m} {}

  [[nodiscard]] Plan plan() {
    const std::vector<std::size_t> rank = ranks_on_b(meetings_);
    BestChange to_a{meetings_.size()};  // changes from b to a, by what they save against a's own arc
    BestChange to_b{meetings_.size()};
    for (std::size_t index = 0; index < meetings_.size(); ++index) {
      const Intersection& meeting = meetings_[index];
      on_a_.push_back(extended(to_a.best(rank[index]), meeting.on_a.arc_m));
      on_b_.push_back(extended(to_b.best(rank[index]), meeting.on_b.arc_m));
      to_a.offer(rank[index], {on_b_[index].length_m + meeting.cost_m - meeting.on_a.arc_m, index});
      to_b.offer(rank[index], {on_a_[index].length_m + meeting.cost_m - meeting.on_b.arc_m, index});
    }
    const Way end_a = extended(to_a.best(meetings_.size() - 1), length_a_m_);
    const Way end_b = extended(to_b.best(meetings_.size() - 1), length_b_m_);
    return end_b.length_m < end_a.length_m ? traced_back(end_b, false) : traced_back(end_a, true);
  }

 private:
  /// The way to `arc_m` along a path: from its beginning, or from the best change onto it.
  static Way extended(const Way& change, double arc_m) {
    return change.length_m < 0.0 ? Way{change.length_m + arc_m, change.changed_at} : Way{arc_m, kNone};
  }
  [[nodiscard]] Plan traced_back(const Way& end, bool ends_on_a) const {
    Plan plan{ends_on_a, {}};
    for (std::size_t change = end.changed_at; change != kNone;) {
      plan.changes.push_back(change);
      plan.begins_on_a = !plan.begins_on_a;
      change = plan.begins_on_a ? on_a_[change].changed_at : on_b_[change].changed_at;
    }
    std::reverse(plan.changes.begin(), plan.changes.end());
    return plan;
  }

  const std::vector<Intersection>& meetings_;
  double length_a_m_;
  double length_b_m_;
  std::vector<Way> on_a_;  // best way to each intersection, arriving along a
  std::vector<Way> on_b_;
};

void append(Path& path, const Point& point) {
  if (path.empty() || path.back() != point) path.push_back(point);
}

Path followed(const Plan& plan, const std::vector<Intersection>& meetings, const Path& a, const Path& b) {
  Path result;
  bool on_a = plan.begins_on_a;
  std::size_t next = 0;
  for (const std::size_t change : plan.changes) {
    const Intersection& meeting = meetings[change];
    const Path& path = on_a ? a : b;
    const std::size_t last = on_a ? meeting.on_a.last_before : meeting.on_b.last_before;
    for (; next <= last; ++next) append(result, path[next]);
    append(result, meeting.point);
    on_a = !on_a;
    next = on_a ? meeting.on_a.next_after : meeting.on_b.next_after;
  }
  const Path& path = on_a ? a : b;
  for (; next < path.size(); ++next) append(result, path[next]);
  return result;
}

bool ends_meet(const Path& a, const Path& b) {
  return (a.front() - b.front()).norm() <= kTouch_m && (a.back() - b.back()).norm() <= kTouch_m;
}

/// A total order of paths that both partners agree on: by length, then vertex by vertex.
bool comes_first(const Path& one, const Path& other) {
  const double length_one_m = length_m(one);
  const double length_other_m = length_m(other);
  if (length_one_m != length_other_m) return length_one_m < length_other_m;
  return std::lexicographical_compare(
      one.begin(), one.end(), other.begin(), other.end(),
      [](const Point& p, const Point& q) { return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y(); });
}

Path snapped(const Path& path) {
  Path result;
  result.reserve(path.size());
  for (const Point& point : path) result.push_back(on_grid(point));
  return result;
}

}  // namespace

Path merge(const Path& own, const Path& other) {
  if (own.size() < 2 || other.size() < 2) return snapped(own.size() < 2 ? other : own);
  Path shorter = snapped(own);
  Path longer = snapped(other);
  if (shorter == longer) return shorter;
  if (comes_first(longer, shorter)) std::swap(shorter, longer);
  if (!ends_meet(shorter, longer)) return shorter;
  const auto meetings = intersections(shorter, longer, kMostIntersections);
  if (!meetings || meetings->empty()) return shorter;
  const double shorter_m = length_m(shorter);
  Plan plan = Planner{*meetings, shorter_m, length_m(longer)}.plan();
  if (plan.changes.empty()) return shorter;
  Path result = followed(plan, *meetings, shorter, longer);
  // By construction each change saves at least 0.5 mm. The comparison guards against rounding in sums of
  // lengths.
  return length_m(result) <= shorter_m ? result : shorter;
}

std::optional<Path> path_after_exchange(const Path& own, const Path& received, double gain_m) {
  if (received.size() < 2) return std::nullopt;
  if (own.empty()) return received;
  Path merged = merge(own, received);
  if (merged.size() < 2 || length_m(merged) > length_m(own) - gain_m) return std::nullopt;
  return merged;
}

}  // namespace caravan::agent
