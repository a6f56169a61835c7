// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/path/route.hpp"

#include <gmock/gmock.h>

namespace caravan::agent {
namespace {

const Path kArc = {{0, 0}, {1, 2}, {2, 3}, {3, 2}, {4, 0}, {6, 0}, {8, 0}};

/// Moves along the goals of the route until its end is reached or `steps` have passed.
Point drive(Route& route, Point p, int steps) {
  for (int i = 0; i < steps && (p - route.end()).norm() > 0.3; ++i) {
    (void)route.advance(p);
    const Point to = route.goal(p) - p;
    if (to.norm() > 1e-9) p += std::min(0.05, to.norm()) * to.normalized();
  }
  return p;
}

TEST(Route, IsFollowedToItsEndInBothDirections) {
  Route out{{}, kArc, true, {0, 0}};
  EXPECT_LT((drive(out, {0, 0}, 1000) - Point{8, 0}).norm(), 0.31);
  Route back{{}, kArc, false, {8, 0}};
  EXPECT_LT((drive(back, {8, 0}, 1000) - Point{0, 0}).norm(), 0.31);
}

TEST(Route, AShortcutIsProvisionalUntilDrivenAndOnlyTheDrivenPathIsGiven) {
  Route route{{}, kArc, true, {0, 0}};
  route.shorten({0, 0}, 4, 1.0, 0.3);
  EXPECT_TRUE(route.is_provisional());
  EXPECT_EQ(route.driven(), kArc);
  Point p = drive(route, {0, 0}, 40);
  EXPECT_EQ(route.driven(), kArc);
  p = drive(route, p, 60);
  EXPECT_FALSE(route.is_provisional());
  EXPECT_NEAR(length_m(route.driven()), 8.0, 1e-6);
}

TEST(Route, ABlockedShortcutGivesTheOldSectionBackAndTheRobotReturnsToIt) {
  Route route{{}, kArc, true, {0, 0}};
  route.shorten({0, 0}, 4, 1.0, 0.3);
  Point p = drive(route, {0, 0}, 30);
  EXPECT_NEAR(p.x(), 1.5, 0.1);
  const Route::Ends blocked = route.restore(p);
  EXPECT_EQ(blocked.from, (Point{0, 0}));
  EXPECT_EQ(blocked.to, (Point{4, 0}));
  EXPECT_FALSE(route.is_provisional());
  EXPECT_EQ(route.plan(), kArc);
  EXPECT_FALSE(route.may_shorten());
  double highest = 0.0;
  for (int i = 0; i < 400; ++i) {
    p = drive(route, p, 1);
    highest = std::max(highest, p.y());
  }
  EXPECT_GT(highest, 2.5) << "it went round by the old section";
  EXPECT_LT((p - Point{8, 0}).norm(), 0.31);
}

TEST(Route, IsBentRoundPlacesProvisionallyUntilDriven) {
  const Path straight = {{0, 0}, {2, 0}, {4, 0}, {6, 0}, {8, 0}};
  const std::vector<Point> places = {{3.0, 0.1}};
  Route route{{}, straight, true, {0, 0}};
  EXPECT_TRUE(route.bend_round(places, 0.6, {0, 0}));
  EXPECT_FALSE(route.bend_round(places, 0.6, {0, 0})) << "it is bent";
  EXPECT_EQ(route.driven(), straight);
  double nearest = 10.0;
  Point p{0, 0};
  for (int i = 0; i < 400; ++i) {
    p = drive(route, p, 1);
    nearest = std::min(nearest, (p - places[0]).norm());
  }
  EXPECT_GT(nearest, 0.5);
  EXPECT_LT((p - Point{8, 0}).norm(), 0.31);
  EXPECT_FALSE(route.is_provisional());
  EXPECT_GT(project(route.driven(), places[0]).distance_m, 0.55) << "others are given what was driven";
}

TEST(Route, ABlockedBendGivesTheOldSectionBack) {
  const Path straight = {{0, 0}, {2, 0}, {4, 0}, {6, 0}, {8, 0}};
  const std::vector<Point> places = {{3.0, 0.1}};
  Route route{{}, straight, true, {0, 0}};
  EXPECT_TRUE(route.bend_round(places, 0.6, {0, 0}));
  const Point p = drive(route, {0, 0}, 55);
  (void)route.restore(p);
  EXPECT_EQ(route.plan(), straight);
  EXPECT_FALSE(route.bend_round(places, 0.6, p)) << "not before the old section lies behind it";
  EXPECT_LT((drive(route, p, 600) - Point{8, 0}).norm(), 0.31);
}

TEST(Route, AfterABlockedShortcutTheOldSectionIsDrivenBeforeTheNextIsTried) {
  Route route{{}, kArc, true, {0, 0}};
  route.shorten({0, 0}, 4, 1.0, 0.3);
  Point p = drive(route, {0, 0}, 30);
  (void)route.restore(p);
  bool early = false;
  for (int i = 0; i < 400 && !route.may_shorten(); ++i) {
    p = drive(route, p, 1);
    early = early || (route.may_shorten() && p.x() < 3.5);
  }
  EXPECT_TRUE(route.may_shorten());
  EXPECT_FALSE(early);
}

TEST(Route, AShortcutOnAShortcutIsGivenUpAsAWhole) {
  const Path arc = {{0, 0}, {1, 2}, {2, 3}, {3, 2}, {4, 0}, {5, -2}, {6, -3}, {7, -2}, {8, 0}, {12, 0}};
  Route route{{}, arc, true, {0, 0}};
  route.shorten({0, 0}, 4, 1.0, 0.3);
  Point p = drive(route, {0, 0}, 50);
  route.shorten(p, route.plan().size() - 2, 1.0, 0.3);
  p = drive(route, p, 40);
  EXPECT_EQ(route.driven(), arc);
  EXPECT_EQ(route.restore(p).to, (Point{8, 0}));
  EXPECT_EQ(route.plan(), arc);
}

TEST(Route, AShortcutOnTheWayBackShortensTheSamePath) {
  Route route{{}, kArc, false, {4, 0}};
  route.shorten({4, 0}, route.plan().size() - 1, 1.0, 0.3);
  Point p = drive(route, {4, 0}, 1000);
  route.turn_round(p);
  EXPECT_NEAR(length_m(route.driven()), 8.0, 1e-6);
  EXPECT_EQ(route.driven().front(), (Point{0, 0}));
  EXPECT_EQ(route.driven().back(), (Point{8, 0}));
  EXPECT_TRUE(route.towards_destination());
}

TEST(Route, AShortcutThatWasNotDrivenToItsEndIsDroppedAtTheEndOfTheWay) {
  Route route{{}, kArc, false, {4, 0}};
  route.shorten({4, 0}, route.plan().size() - 1, 1.0, 0.3);
  route.turn_round({3.5, 0});
  EXPECT_EQ(route.driven(), kArc);
}

TEST(Route, ABetterPathIsTakenWhereTheOldOneMeetsIt) {
  const Path upper = {{0, 0}, {0, 4}, {4, 4}, {8, 4}, {8, 0}};
  const Path merged = {{0, 0}, {4, 0}, {8, 0}};
  Route route{{}, upper, true, {0, 0}};
  Point p = drive(route, {0, 0}, 120);  // on its way along the upper path
  route.replace(merged, p);
  EXPECT_EQ(route.driven(), merged);
  for (int i = 0; i < 600; ++i) {
    p = drive(route, p, 1);
    EXPECT_LT(project(upper, p).distance_m, 0.4) << "it stays on the path that it knows";
  }
  EXPECT_LT((p - Point{8, 0}).norm(), 0.31);
}

TEST(Route, ARobotThatWanderedPicksThePathUpWhereItIsNearest) {
  Route route{{}, kArc, true, {0, 0}};
  route.shorten({0, 0}, 4, 1.0, 0.3);
  route.rejoin({6.2, 1.5});
  EXPECT_FALSE(route.is_provisional());
  EXPECT_EQ(route.plan(), kArc);
  EXPECT_NEAR(route.remaining_m({6.2, 1.5}), std::hypot(1.8, 1.5), 1e-6);
}

}  // namespace
}  // namespace caravan::agent
