// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/config/robot_list.hpp"

#include <gmock/gmock.h>

#include "runtime/config/start_error.hpp"

namespace caravan::agent {
namespace {

using runtime::StartError;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(RobotList, HoldsNumbersAndRangesSorted) {
  EXPECT_THAT(parse_robot_list("7"), ElementsAre(7));
  EXPECT_THAT(parse_robot_list("1-4"), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(parse_robot_list("9,1,3-5"), ElementsAre(1, 3, 4, 5, 9));
  EXPECT_THAT(parse_robot_list("6-6"), ElementsAre(6));
  EXPECT_EQ(parse_robot_list("1-65535").size(), 65535U);
}

TEST(RobotList, RefusesWhatIsWrittenOtherwise) {
  for (const std::string text : {"", ",", "1,", ",1", "1,,2", "1-", "-3", "1-2-3", "1 2", "a", "1a", "1.5",
                                 "+1", "0", "0-3", "65536", "1-65536", "99999999999"}) {
    SCOPED_TRACE(text);
    EXPECT_THAT([&] { (void)parse_robot_list(text); },
                ThrowsMessage<StartError>(HasSubstr("--robots " + text + ":")));
  }
}

TEST(RobotList, RefusesARangeFromHighToLow) {
  EXPECT_THAT([] { (void)parse_robot_list("5-3"); },
              ThrowsMessage<StartError>(HasSubstr("from low to high")));
}

TEST(RobotList, RefusesARobotThatIsInItTwiceAndNamesIt) {
  for (const std::string text : {"4,4", "1-5,4", "3-6,1-4"}) {
    EXPECT_THAT([&] { (void)parse_robot_list(text); },
                ThrowsMessage<StartError>(AllOf(HasSubstr("robot "), HasSubstr("twice"))));
  }
}

}  // namespace
}  // namespace caravan::agent
