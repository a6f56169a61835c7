// SPDX-License-Identifier: Apache-2.0
#include "runtime/config/setting.hpp"

#include <gmock/gmock.h>

#include "runtime/config/toml_table.hpp"

namespace caravan::runtime {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

Setting set(const std::string& text) { return read_setting(text, "--set"); }

TomlDocument changed(const std::string& scenario, const std::vector<std::string>& texts) {
  Settings settings;
  for (const std::string& text : texts) settings.push_back(set(text));
  return TomlDocument::parse(scenario, "course.toml", settings);
}

std::string error_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const StartError& error) {
    return error.what();
  }
  return "none";
}

TEST(Setting, IsAKeyAndAValueOfToml) {
  const Setting setting = set("radio.range_m = 2.5 ");
  EXPECT_EQ(setting.key, "radio.range_m");
  EXPECT_EQ(setting.value, "2.5");
  EXPECT_EQ(setting.origin, "--set radio.range_m=2.5");
}

TEST(Setting, SeveralValuesAreSeparatedByCommasOutsideBracketsAndQuotes) {
  EXPECT_THAT(read_key_values("a.b=1, 2,3", "--set").values, ElementsAre("1", "2", "3"));
  EXPECT_THAT(read_key_values("a.b=[1,2],[3, 4]", "--set").values, ElementsAre("[1,2]", "[3, 4]"));
  EXPECT_THAT(read_key_values(R"(a.b="x,y",'z,"',none)", "--set").values,
              ElementsAre(R"("x,y")", R"('z,"')", "none"));
}

TEST(Setting, AWordNeedsNoQuotesAndIsTheSameWithThem) {
  EXPECT_EQ(set("algorithm.mode=none").value, "none");
  EXPECT_EQ(set("algorithm.mode=\"none\"").value, "none");
  EXPECT_EQ(set("a.b=\"two words\"").value, "\"two words\"");
  for (const std::string text : {"none", "lib/my.so", "/a/b-c.py", "x2"}) EXPECT_TRUE(is_word(text)) << text;
  for (const std::string text : {"", "true", "false", "nan", "inf", "2", "-x", "a b", "a\"b"})
    EXPECT_FALSE(is_word(text)) << text;
}

TEST(Setting, OfAnotherFormIsRefused) {
  const auto refusal = [](const std::string& text) { return error_of([&] { (void)set(text); }); };
  EXPECT_THAT(refusal("radio.range_m"), StartsWith("--set radio.range_m: is not of the form"));
  EXPECT_THAT(refusal("=4"), HasSubstr("is not a key"));
  EXPECT_THAT(refusal("radio..range_m=4"), HasSubstr("is not a key"));
  EXPECT_THAT(refusal("radio.range m=4"), HasSubstr("is not a key"));
  EXPECT_THAT(refusal("radio.range_m="), StartsWith("--set radio.range_m=: has no value"));
  EXPECT_THAT(refusal("radio.range_m=2,,4"), HasSubstr("one of its values is empty"));
  EXPECT_THAT(refusal("radio.range_m=2,2"), HasSubstr("names 2 twice"));
  EXPECT_THAT(refusal("radio.range_m=2,4"), HasSubstr("takes one value here"));
  EXPECT_THAT(refusal("radio.range_m=2\nseed = 3"), HasSubstr("more than one line"));
}

TEST(Setting, TakesThePlaceOfTheFilesValueAndMakesTablesThatAreMissing) {
  const TomlDocument scenario = changed("[radio]\nrange_m = 2.0\nmtu_bytes = 9\n",
                                        {"radio.range_m=4", "algorithm.mode=none", "seed=7"});

  double range_m = 0.0;
  std::uint32_t mtu_bytes = 0;
  TomlTable radio = scenario.table("radio");
  radio.read("range_m", range_m);
  radio.read("mtu_bytes", mtu_bytes);
  EXPECT_EQ(range_m, 4.0);
  EXPECT_EQ(mtu_bytes, 9U);
  std::string mode;
  scenario.table("algorithm").read("mode", mode);
  EXPECT_EQ(mode, "none");
  std::uint64_t seed = 0;
  scenario.root().read("seed", seed);
  EXPECT_EQ(seed, 7U);
}

TEST(Setting, IsNamedByErrorsOfItsReader) {
  const TomlDocument scenario = changed("[radio]\nrange_m = 2.0\n",
                                        {"radio.range_m=-1", "radio.colour=3", "robots.source_m=[1,\"x\"]"});

  double range_m = 0.0;
  TomlTable radio = scenario.table("radio");
  EXPECT_EQ(error_of([&] { radio.read("range_m", range_m, kNotNegative); }),
            "--set radio.range_m=-1: must be at least 0, is -1");
  EXPECT_EQ(error_of([&] { radio.refuse_unknown(); }), "--set radio.colour=3: unknown key");
  std::array<double, 2> source_m{};
  EXPECT_EQ(error_of([&] { scenario.table("robots").read("source_m", source_m); }),
            "--set robots.source_m=[1,\"x\"]: must be a number");
}

TEST(Setting, LeavesTheLinesOfOtherKeysInErrors) {
  const TomlDocument scenario = changed("[radio]\nrange_m = -2.0\n", {"radio.mtu_bytes=9"});
  double range_m = 0.0;
  EXPECT_THAT(error_of([&] { scenario.table("radio").read("range_m", range_m, kNotNegative); }),
              StartsWith("course.toml:2: radio.range_m: must be"));
}

TEST(Setting, OfAnUnknownTableIsRefused) {
  EXPECT_EQ(error_of([] { (void)changed("", {"colours.red=1"}); }),
            "--set colours.red=1: colours: unknown key");
}

TEST(Setting, ThatIsNoTomlIsRefused) {
  EXPECT_THAT(error_of([] { (void)changed("", {"radio.range_m=2 m"}); }),
              StartsWith("--set radio.range_m=2 m: is not a value of TOML: "));
}

TEST(Setting, ReachesAListAsAWholeOnly) {
  const std::string boxes = "[[world.box]]\nyaw_rad = 0\n[[world.box]]\nyaw_rad = 0\n";
  EXPECT_THAT(error_of([&] { (void)changed(boxes, {"world.box.yaw_rad=1"}); }),
              HasSubstr("world.box is not a table; the elements of a list cannot be set"));
  const TomlDocument scenario = changed(boxes, {"world.box=[{yaw_rad=1}]"});
  TomlTable world = scenario.table("world");
  EXPECT_EQ(world.tables("box").size(), 1U);
}

TEST(Values, OfAnyKindAreReadAsText) {
  const TomlDocument file = TomlDocument::parse(
      R"(world = { one = 2.0, list = [1, 2.5, "none", "two words", true, [1, 2]], rows = [[1, "a"], [2, "b"]], none = [] })",
      "plan.toml");
  TomlTable table = file.table("world");
  EXPECT_EQ(table.value("one"), "2.0");
  EXPECT_EQ(table.value("absent"), "");
  EXPECT_THAT(table.values("list"), ElementsAre("1", "2.5", "none", "\"two words\"", "true", "[1, 2]"));
  EXPECT_THAT(table.rows("rows"), ElementsAre(ElementsAre("1", "a"), ElementsAre("2", "b")));
  EXPECT_THAT(error_of([&] { (void)table.values("none"); }), HasSubstr("at least one value"));
}

}  // namespace
}  // namespace caravan::runtime
