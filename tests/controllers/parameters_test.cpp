// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <caravan/parameters.hpp>

namespace caravan {
namespace {

using testing::ElementsAre;

Parameters some() {
  return Parameters{{{"gain", 0.5},
                     {"count", std::int64_t{3}},
                     {"on", true},
                     {"name", std::string{"left"}},
                     {"weights", std::vector<double>{1.0, 2.0}}}};
}

std::string refusal(const std::function<void(Parameters&)>& ask) {
  Parameters parameters = some();
  try {
    ask(parameters);
  } catch (const ParameterError& error) {
    return error.key() + ": " + error.what();
  }
  return "";
}

TEST(Parameters, GiveTheScenariosValuesAndOtherwiseTheDefaults) {
  Parameters parameters = some();
  EXPECT_EQ(parameters.number("gain", 1.0), 0.5);
  EXPECT_EQ(parameters.number("count", 1.0), 3.0) << "an integer is a number";
  EXPECT_EQ(parameters.integer("count", 1), 3);
  EXPECT_TRUE(parameters.flag("on", false));
  EXPECT_EQ(parameters.text("name", "right"), "left");
  EXPECT_THAT(parameters.numbers("weights", {}), ElementsAre(1.0, 2.0));
  EXPECT_EQ(parameters.number("missing", 7.0), 7.0);
  EXPECT_EQ(parameters.text("also_missing", "right"), "right");
}

TEST(Parameters, RefuseAnotherTypeAndAValueOutsideTheLimits) {
  EXPECT_EQ(refusal([](Parameters& p) { (void)p.number("name", 1.0); }), "name: must be a number");
  EXPECT_EQ(refusal([](Parameters& p) { (void)p.integer("gain", 1); }), "gain: must be an integer");
  EXPECT_EQ(refusal([](Parameters& p) { (void)p.flag("count", true); }), "count: must be true or false");
  EXPECT_EQ(refusal([](Parameters& p) {
              (void)p.number("gain", 0.1, {0.0, 0.25});
            }),
            "gain: must be from 0 to 0.25, is 0.5");
  EXPECT_EQ(refusal([](Parameters& p) {
              (void)p.integer("count", 10, {10, 20});
            }),
            "count: must be from 10 to 20, is 3");
  EXPECT_EQ(refusal([](Parameters& p) {
              (void)p.numbers("weights", {}, {0.0, 1.5});
            }),
            "weights: must be from 0 to 1.5, is 2");
}

TEST(Parameters, RefuseADefaultOutsideItsOwnLimits) {
  EXPECT_EQ(refusal([](Parameters& p) {
              (void)p.number("missing", 3.0, {0.0, 2.0});
            }),
            "missing: its default is 3, outside its own limits: 0 to 2");
  EXPECT_EQ(refusal([](Parameters& p) {
              (void)p.integer("count", 0, {1, 9});
            }),
            "count: its default is 0, outside its own limits: 1 to 9")
      << "also when the scenario has the key";
  EXPECT_EQ(refusal([](Parameters& p) {
              (void)p.numbers("missing", {1.0, 3.0}, {0.0, 2.0});
            }),
            "missing: its default is 3, outside its own limits: 0 to 2");
  EXPECT_EQ(
      refusal([](Parameters& p) { (void)p.number("missing", std::numeric_limits<double>::infinity()); }), "")
      << "without limits";
}

TEST(Parameters, AreFiniteAndSayOnlyTheLimitsThatThereAre) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity}) {
    Parameters parameters{{{"gain", value}}};
    try {
      (void)parameters.number("gain", 1.0, {-kInfinity, kInfinity});
      ADD_FAILURE() << value;
    } catch (const ParameterError& error) {
      EXPECT_STREQ(error.what(), "must be a finite number");
    }
  }
  EXPECT_EQ(refusal([](Parameters& p) { (void)p.number("gain", 3.0, {.low = 2.0}); }),
            "gain: must be at least 2, is 0.5");
  EXPECT_EQ(refusal([](Parameters& p) { (void)p.number("gain", -2e300, {.high = -1e300}); }),
            "gain: must be at most -1e+300, is 0.5");
}

TEST(Parameters, KnowWhichKeysNobodyHasAskedFor) {
  Parameters parameters = some();
  (void)parameters.number("gain", 1.0);
  (void)parameters.text("name", "");
  EXPECT_THAT(parameters.unknown(), ElementsAre("count", "on", "weights"));
  EXPECT_THAT(parameters.known(), ElementsAre("gain", "name"));
}

}  // namespace
}  // namespace caravan
