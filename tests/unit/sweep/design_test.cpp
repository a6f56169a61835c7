// SPDX-License-Identifier: Apache-2.0
#include "experiment/sweep/design.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

namespace caravan::experiment {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using Point = std::vector<std::string>;

Factor listed(const std::string& key, std::vector<std::string> values, const std::string& base = "") {
  return {.axis = {key, "--set "}, .values = std::move(values), .base = base};
}
Factor ranged(const std::string& key, double low, double high, bool whole = false) {
  return {.axis = {key, "--set "}, .low = low, .high = high, .whole = whole};
}

template <typename Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const runtime::StartError& error) {
    return error.what();
  }
  return "none";
}

TEST(Design, WithoutAxesIsOnePoint) {
  EXPECT_THAT(Design{}.points, ElementsAre(Point{}));
  EXPECT_EQ(folder_of(Design{}, 0), "");
}

TEST(FullFactorial, HasEveryCombinationOnceTheLastFactorFastest) {
  const Design design = full_factorial(std::vector{listed("a.x", {"1", "2"}), listed("b.y", {"u", "v"})});
  EXPECT_THAT(design.points, ElementsAre(Point{"1", "u"}, Point{"1", "v"}, Point{"2", "u"}, Point{"2", "v"}));
  EXPECT_EQ(design.axes[1].key, "b.y");
}

TEST(OneAtATime, VariesEachFactorWithTheOthersAtTheirBase) {
  const Design design =
      one_at_a_time(std::vector{listed("a.x", {"1", "2", "3"}, "2"), listed("b.y", {"u", "v"}, "u")});
  EXPECT_THAT(design.points, ElementsAre(Point{"2", "u"}, Point{"1", "u"}, Point{"3", "u"}, Point{"2", "v"}));
}

TEST(LatinHypercube, UsesEachPartOfEachRangeOnce) {
  constexpr std::size_t kPoints = 50;
  const Design design =
      latin_hypercube(std::vector{ranged("a.x", -1.0, 4.0), ranged("b.y", 10.0, 20.0)}, kPoints, 3);
  ASSERT_THAT(design.points, SizeIs(kPoints));
  for (const auto& [axis, low, width] : {std::tuple{0U, -1.0, 5.0}, std::tuple{1U, 10.0, 10.0}}) {
    std::set<int> parts;
    for (const Point& point : design.points) {
      const double value = std::stod(point[axis]);
      EXPECT_GE(value, low);
      EXPECT_LT(value, low + width);
      parts.insert(static_cast<int>((value - low) / width * kPoints));
    }
    EXPECT_THAT(parts, SizeIs(kPoints)) << axis;
  }
}

TEST(LatinHypercube, GivesWholeNumbersAndListedValuesTheirShare) {
  const Design design = latin_hypercube(
      std::vector{ranged("a.x", 0.0, 1.0), ranged("b.y", 5.0, 8.0, true), listed("c.z", {"u", "v"})}, 40, 1);
  std::map<std::string, int> whole;
  std::map<std::string, int> values;
  for (const Point& point : design.points) {
    ++whole[point[1]];
    ++values[point[2]];
  }
  EXPECT_THAT(whole,
              ElementsAre(std::pair{"5", 10}, std::pair{"6", 10}, std::pair{"7", 10}, std::pair{"8", 10}));
  EXPECT_THAT(values, ElementsAre(std::pair{"u", 20}, std::pair{"v", 20}));
}

TEST(LatinHypercube, DependsOnItsSeedAlone) {
  const std::vector factors{ranged("a.x", 0.0, 1.0), ranged("b.y", 0.0, 1.0)};
  EXPECT_EQ(latin_hypercube(factors, 20, 1).points, latin_hypercube(factors, 20, 1).points);
  EXPECT_NE(latin_hypercube(factors, 20, 1).points, latin_hypercube(factors, 20, 2).points);
  const Design design = latin_hypercube(factors, 20, 1);
  EXPECT_NE(design.points[0][0], design.points[0][1]) << "factors are shuffled independently";
}

TEST(LatinHypercube, HasEqualPointsOnce) {
  EXPECT_THAT(latin_hypercube(std::vector{ranged("a.x", 1.0, 3.0, true)}, 30, 1).points, SizeIs(3));
}

TEST(Crossed, HasEachPointOfOneWithEachOfTheOther) {
  const Design one = full_factorial(std::vector{listed("a.x", {"1", "2"})});
  const Design other = explicit_points({{"b.y", ""}, {"c.z", ""}}, {{"3", "4"}, {"5", "6"}, {"3", "4"}});
  EXPECT_THAT(crossed(one, other).points, ElementsAre(Point{"1", "3", "4"}, Point{"1", "5", "6"},
                                                      Point{"2", "3", "4"}, Point{"2", "5", "6"}));
}

TEST(Design, RefusesAKeyTwiceAndTooManyPoints) {
  EXPECT_EQ(error_of([] {
              (void)full_factorial(std::vector{listed("a.x", {"1"}), listed("a.x", {"2"})});
            }),
            "--set a.x: two axes have this key");
  std::vector<std::string> many;
  for (int i = 0; i < 400; ++i) many.push_back(std::to_string(i));
  EXPECT_THAT(error_of([&] {
                (void)full_factorial(std::vector{listed("a.x", many), listed("b.y", many)});
              }),
              HasSubstr("more than 100000 points"));
}

TEST(Point, HasASettingForEachAxis) {
  const Design design = explicit_points({{"a.x", "--set "}, {"b.y", "plan.toml:3: "}}, {{"1", "none"}});
  const runtime::Settings settings = settings_at(design, 0);
  ASSERT_THAT(settings, SizeIs(2));
  EXPECT_EQ(settings[0].origin, "--set a.x=1");
  EXPECT_EQ(settings[1].key, "b.y");
  EXPECT_EQ(settings[1].value, "none");
  EXPECT_EQ(settings[1].origin, "plan.toml:3: b.y=none");
}

TEST(Point, HasAFolderOfItsOwnWhateverItsValues) {
  const std::string length(300, 'x');
  const Design design =
      explicit_points({{"a.x", ""}, {"b.y", ""}},
                      {{"1", "none"}, {"../..", "1"}, {"/..", "1"}, {length, "1"}, {length, "2"}});
  std::set<std::string> names;
  for (std::size_t i = 0; i < design.points.size(); ++i) {
    const std::string name = folder_of(design, i);
    EXPECT_EQ(name.find('/'), std::string::npos) << name;
    EXPECT_LE(name.size(), 150U);
    names.insert(name);
  }
  EXPECT_THAT(names, SizeIs(5));
  EXPECT_EQ(folder_of(design, 0), "a.x=1,b.y=none");
}

}  // namespace
}  // namespace caravan::experiment
