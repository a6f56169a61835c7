// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/radio/exchange/transfer.hpp"

#include <gmock/gmock.h>

#include <limits>

namespace caravan::agent {
namespace {

Path straight(std::size_t points) {
  Path path;
  for (std::size_t index = 0; index < points; ++index) path.push_back(on_grid({0.1 * double(index), -1.5}));
  return path;
}
bool crossed(const Transfer& transfer) { return transfer.holds_all() && transfer.has_given(); }

TEST(Transfer, CrossesTwoPathsInAsManyFragmentsAsTheLongerNeeds) {  // P-40
  Transfer one{straight(45), true, 20};
  Transfer other{straight(7), true, 20};
  int rounds = 0;
  for (; !(crossed(one) && crossed(other)); ++rounds) {
    ASSERT_LT(rounds, 10);
    const PathFragment to_other = one.next();
    const PathFragment to_one = other.next();
    one.absorb(to_one);
    other.absorb(to_other);
  }
  EXPECT_EQ(rounds, 4);  // three fragments, and one step for the last acknowledgement
  EXPECT_EQ(one.partners_path(), straight(7));
  EXPECT_EQ(other.partners_path(), straight(45));
}

TEST(Transfer, SendsTheUnacknowledgedPartRoundAndRound) {  // P-41
  Transfer giver{straight(10), true, 4};
  const auto firsts = [&giver](int count) {
    std::vector<int> result;
    for (; count > 0; --count) result.push_back(giver.next().first);
    return result;
  };
  EXPECT_THAT(firsts(4), testing::ElementsAre(0, 4, 8, 0));
  giver.absorb({{}, {}, 1, 0, 0, true, 6, {}});
  EXPECT_THAT(firsts(3), testing::ElementsAre(6, 6, 6));
  giver.absorb({{}, {}, 1, 0, 0, true, 10, {}});
  EXPECT_EQ(giver.next().first, 10);
  EXPECT_TRUE(giver.next().points.empty());
}

TEST(Transfer, KeepsFragmentsThatArriveOutOfOrderAndTwice) {  // P-42
  Transfer giver{straight(6), true, 2};
  const PathFragment first = giver.next();
  const PathFragment second = giver.next();
  const PathFragment third = giver.next();
  Transfer taker{{}, true, 2};
  taker.absorb(third);
  EXPECT_EQ(taker.next().holds, 0);
  taker.absorb(first);
  taker.absorb(first);
  EXPECT_EQ(taker.next().holds, 2);
  taker.absorb(second);
  EXPECT_EQ(taker.next().holds, 6);
  EXPECT_EQ(taker.partners_path(), straight(6));
}

TEST(Transfer, OfNoPathIsOverWhenBothHaveHeardEachOther) {  // P-43
  Transfer one{{}, true, 20};
  Transfer other{{}, true, 20};
  EXPECT_FALSE(one.holds_all());
  one.absorb(other.next());
  EXPECT_TRUE(one.holds_all());
  EXPECT_FALSE(one.has_given());
  other.absorb(one.next());
  EXPECT_TRUE(crossed(other));
  one.absorb(other.next());
  EXPECT_TRUE(crossed(one));
  EXPECT_TRUE(one.partners_path().empty());
}

TEST(Transfer, AGiverThatWantsNothingAcknowledgesWithoutKeeping) {  // P-44
  Transfer giver{straight(3), false, 20};
  Transfer other{straight(5), true, 20};
  giver.absorb(other.next());
  EXPECT_TRUE(giver.holds_all());
  EXPECT_TRUE(giver.partners_path().empty());
  other.absorb(giver.next());
  EXPECT_TRUE(other.has_given());
}

TEST(Transfer, IgnoresFragmentsThatContradictTheFirst) {  // P-45
  Transfer taker{straight(2), true, 20};
  taker.absorb({{}, {}, 1, 3, 0, false, 0, {{1, 1}, {2, 2}}});
  taker.absorb({{}, {}, 1, 4, 2, true, 2, {{9, 9}, {9, 9}}});
  EXPECT_FALSE(taker.holds_all());
  EXPECT_FALSE(taker.has_given());
  taker.absorb({{}, {}, 1, 3, 0, true, 0, {{8, 8}}});  // already known: the first value stays
  taker.absorb({{}, {}, 1, 3, 2, true, 0, {{3, 3}}});
  EXPECT_THAT(taker.partners_path(),
              testing::ElementsAre(Point{0.001, 0.001}, Point{0.002, 0.002}, Point{0.003, 0.003}));
}

TEST(Transfer, BearsOddValues) {  // P-45
  Transfer taker{straight(2), true, 20};
  taker.absorb({{}, {}, 1, 3, 2, true, 0, {{1, 1}, {1, 1}}});  // beyond its own total
  EXPECT_FALSE(taker.next().has_heard);
  taker.absorb({{}, {}, 1, 65535, 65535, true, 9, {}});  // acknowledges more than there is
  EXPECT_FALSE(taker.has_given());
  EXPECT_EQ(taker.next().first, 0);
  taker.absorb({{}, {}, 1, 65535, 65534, true, 2, {{1, 1}}});
  EXPECT_TRUE(taker.has_given());
  EXPECT_FALSE(taker.holds_all());
}

TEST(Transfer, GivesNoPathThatAFrameCannotAnnounce) {
  Transfer giver{straight(65536), true, 20};
  EXPECT_EQ(giver.next().total, 0);
  Transfer point{straight(1), true, 20};
  EXPECT_EQ(point.next().total, 0);
}

TEST(Transfer, PointsSurviveTheGridAndCoordinatesAreCutAtItsEnd) {
  for (const Point& point : {Point{1.234, -5.678}, Point{-21.5, 25.0}, Point{0.001, 0.0}}) {
    EXPECT_EQ(from_grid(to_grid(point)), point);
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(to_grid({1e30, -1e30}), (GridPoint{2147483647, -2147483647}));
  EXPECT_EQ(to_grid({nan, 0.0}), (GridPoint{0, 0}));
}

}  // namespace
}  // namespace caravan::agent
