// SPDX-License-Identifier: Apache-2.0
#include "experiment/sweep/plan_file.hpp"

#include <gmock/gmock.h>

#include "runtime/config/start_error.hpp"
#include "tests/unit/sweep/folders.hpp"

namespace caravan::experiment {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using Point = std::vector<std::string>;

class PlanFile : public testing::Test {
 protected:
  Design read(const std::string& text) {
    write(file_, text);
    return read_plan(file_);
  }
  /// Without the name of the folder.
  std::string refusal(const std::string& text) {
    try {
      (void)read(text);
    } catch (const runtime::StartError& error) {
      const std::string why = error.what();
      return why.substr(why.find("plan.toml"));
    }
    return "none";
  }

  Folder folder_;
  std::filesystem::path file_ = folder_.path() / "plan.toml";
};

TEST_F(PlanFile, OfAFactorialHasEveryCombination) {
  const Design design = read(
      "design = \"factorial\"\n[[factor]]\nkey = \"radio.range_m\"\nvalues = [2, 4.5]\n"
      "[[factor]]\nkey = \"algorithm.mode\"\nvalues = [\"none\", \"full\"]\n");
  EXPECT_THAT(design.points, ElementsAre(Point{"2", "none"}, Point{"2", "full"}, Point{"4.5", "none"},
                                         Point{"4.5", "full"}));
  EXPECT_EQ(design.axes[0].place, file_.string() + ":3: ");
}

TEST_F(PlanFile, OfOneAtATimeBeginsWithTheBase) {
  const Design design = read(
      "design = \"one_at_a_time\"\n[[factor]]\nkey = \"a.x\"\nbase = 2\nvalues = [1, 2]\n"
      "[[factor]]\nkey = \"b.y\"\nbase = 5\nvalues = [6]\n");
  EXPECT_THAT(design.points, ElementsAre(Point{"2", "5"}, Point{"1", "5"}, Point{"2", "6"}));
}

TEST_F(PlanFile, OfALatinHypercubeTakesWholeNumbersForWholeBounds) {
  const Design design = read(
      "design = \"latin_hypercube\"\npoints = 10\nseed = 4\n[[factor]]\nkey = \"a.x\"\nlow = 0.0\nhigh = 1\n"
      "[[factor]]\nkey = \"b.y\"\nlow = 1\nhigh = 100\n");
  EXPECT_THAT(design.points, SizeIs(10));
  for (const Point& point : design.points) {
    EXPECT_NE(point[0].find('.'), std::string::npos) << point[0];
    EXPECT_EQ(point[1].find('.'), std::string::npos) << point[1];
  }
}

TEST_F(PlanFile, OfRowsHasThem) {
  EXPECT_THAT(read("design = \"rows\"\nkeys = [\"a.x\", \"b.y\"]\nrows = [[1, \"u\"], [2, \"v\"]]\n").points,
              ElementsAre(Point{"1", "u"}, Point{"2", "v"}));
}

TEST_F(PlanFile, ThatIsWrongIsRefusedAtItsLine) {
  const std::string factor = "[[factor]]\nkey = \"a.x\"\n";
  EXPECT_THAT(refusal(""), HasSubstr("plan.toml:1: design: a plan needs a design"));
  EXPECT_THAT(refusal("design = \"best\"\n"), HasSubstr("plan.toml:1: design: must be one of"));
  EXPECT_THAT(refusal("design = \"factorial\"\n"), HasSubstr("at least one [[factor]]"));
  EXPECT_THAT(refusal("design = \"factorial\"\n" + factor + "values = []\n"),
              HasSubstr("plan.toml:4: factor.values: must be a list of at least one value"));
  EXPECT_THAT(refusal("design = \"factorial\"\n" + factor + "values = [1, 1]\n"), HasSubstr("names 1 twice"));
  EXPECT_THAT(refusal("design = \"factorial\"\n" + factor + "low = 1\nhigh = 2\n"),
              HasSubstr("needs values"));
  EXPECT_THAT(refusal("design = \"factorial\"\n" + factor + "values = [1]\ncolour = 2\n"),
              HasSubstr("plan.toml:5: factor.colour: unknown key"));
  EXPECT_THAT(refusal("design = \"factorial\"\npoints = 3\n" + factor + "values = [1]\n"),
              HasSubstr("plan.toml:2: points: unknown key"));
  EXPECT_THAT(refusal("design = \"factorial\"\n[[factor]]\nkey = \"a x\"\nvalues = [1]\n"),
              HasSubstr("plan.toml:3: factor.key: a x is not a key"));
  EXPECT_THAT(refusal("design = \"one_at_a_time\"\n" + factor + "values = [1]\n"),
              HasSubstr("factor.base: "));
  EXPECT_THAT(refusal("design = \"latin_hypercube\"\n" + factor + "low = 1\nhigh = 2\n"),
              HasSubstr("points: "));
  EXPECT_THAT(refusal("design = \"latin_hypercube\"\npoints = 3\n" + factor + "low = 3\nhigh = 2\n"),
              HasSubstr("plan.toml:6: factor.high: must be at least low"));
  EXPECT_THAT(refusal("design = \"latin_hypercube\"\npoints = 3\n" + factor + "low = 3\n"),
              HasSubstr("needs values, or low and high"));
  EXPECT_THAT(refusal("design = \"rows\"\nkeys = [\"a.x\"]\nrows = [[1, 2]]\n"),
              HasSubstr("plan.toml:3: rows: row 1 has 2 values, and there are 1 keys"));
  EXPECT_THAT(refusal("design = \"rows\"\nkeys = [\"a.x\"]\nrows = []\n"), HasSubstr("plan.toml:3: rows: "));
}

}  // namespace
}  // namespace caravan::experiment
