// SPDX-License-Identifier: Apache-2.0
#include "runtime/config/number_list.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "runtime/config/start_error.hpp"

namespace caravan::runtime {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing::ThrowsMessage;

const NumberListRule kRobots{.option = "--robots", .lowest = 1, .highest = 65535, .most = 65535};
const NumberListRule kSeeds{
    .option = "--seeds", .lowest = 0, .highest = std::numeric_limits<std::int64_t>::max(), .most = 100};

void expect_refused(const std::string& text, const NumberListRule& rule, const std::string& reason) {
  EXPECT_THAT([&] { (void)read_number_list(text, rule); },
              ThrowsMessage<StartError>(AllOf(HasSubstr(rule.option + " " + text + ":"), HasSubstr(reason))))
      << text;
}

TEST(NumberList, HoldsNumbersAndRangesSorted) {
  EXPECT_THAT(read_number_list("7", kRobots), ElementsAre(7));
  EXPECT_THAT(read_number_list("1-4", kRobots), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(read_number_list("9,1,3-5", kRobots), ElementsAre(1, 3, 4, 5, 9));
  EXPECT_THAT(read_number_list("6-6", kRobots), ElementsAre(6));
  EXPECT_THAT(read_number_list("1-65535", kRobots), SizeIs(65535));
  EXPECT_THAT(read_number_list("0,9223372036854775807", kSeeds), ElementsAre(0, 9223372036854775807ULL));
}

TEST(NumberList, RefusesWhatIsWrittenOtherwise) {
  for (const std::string text :
       {"", ",", "1,", ",1", "1,,2", "1-", "-3", "1-2-3", "1 2", "1 - 3", "a", "1a", "1.5", "+1"}) {
    expect_refused(text, kRobots, "is not a list of numbers and ranges");
  }
}

TEST(NumberList, RefusesNumbersOutOfBoundsAndNamesTheBounds) {
  for (const std::string text : {"0", "0-3", "65536", "1-65536", "99999999999999999999"}) {
    expect_refused(text, kRobots, "1 to 65535");
  }
  expect_refused("9223372036854775808", kSeeds, "0 to 9223372036854775807");
}

TEST(NumberList, RefusesARangeThatRunsBackwards) { expect_refused("5-3", kRobots, "5-3 runs backwards"); }

TEST(NumberList, RefusesANumberThatIsInItTwiceAndNamesIt) {
  for (const std::string text : {"4,4", "1-5,4", "3-6,4"}) expect_refused(text, kRobots, "4 is listed twice");
}

TEST(NumberList, RefusesMoreThanAnybodyMeans) {
  EXPECT_THAT(read_number_list("1-100", kSeeds), SizeIs(100));
  expect_refused("1-100,200", kSeeds, "more than 100");
  expect_refused("0-9223372036854775807", kSeeds, "more than 100");
}

}  // namespace
}  // namespace caravan::runtime
