// SPDX-License-Identifier: Apache-2.0
#include "deploy/control/words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace caravan::deploy {
namespace {

namespace kind = caravan_interfaces::msg::ControlRequest_Constants;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

caravan_interfaces::msg::ControlRequest read(const std::string& line) {
  const auto request = read_control(Words{split(line)});
  EXPECT_TRUE(request) << line;
  return request.value_or(caravan_interfaces::msg::ControlRequest{});
}

std::string error_of(const std::string& line) {
  try {
    (void)read_control(Words{split(line)});
  } catch (const WordsError& error) {
    return error.what();
  }
  return "none";
}

TEST(ControlWords, ReadEachForm) {
  EXPECT_EQ(read("pause").action(), kind::PAUSE);
  EXPECT_EQ(read("pause at 120").at_step(), 120U);
  EXPECT_EQ(read("resume").action(), kind::RESUME);
  EXPECT_EQ(read("step").steps(), 1U);
  EXPECT_EQ(read("step 25").steps(), 25U);
  EXPECT_EQ(read("speed 2.5").speed_factor(), 2.5);
  EXPECT_EQ(read("speed max").speed_factor(), 0.0);
  const auto spawn = read("spawn 4 1.5 -2 at 9");
  EXPECT_EQ(spawn.action(), kind::SPAWN);
  EXPECT_THAT(spawn.robots(), ElementsAre(4));
  EXPECT_EQ(spawn.y_m(), -2.0);
  EXPECT_THAT(read("remove 2").robots(), ElementsAre(2));
  EXPECT_EQ(read("hold 3").action(), kind::HOLD);
  EXPECT_EQ(read("release 3 at 9").action(), kind::RELEASE);
  const auto teleport = read("teleport 3 -1.5 2 0.5 at 7");
  EXPECT_EQ(teleport.action(), kind::TELEPORT);
  EXPECT_THAT(teleport.robots(), ElementsAre(3));
  EXPECT_EQ(teleport.x_m(), -1.5);
  EXPECT_EQ(teleport.y_m(), 2.0);
  EXPECT_EQ(teleport.yaw_rad(), 0.5);
  EXPECT_EQ(teleport.at_step(), 7U);
  EXPECT_EQ(read("teleport 3 1 2 at 7").yaw_rad(), 0.0);
}

TEST(ControlWords, ReadWhichLinksAreMeant) {
  const auto pair = read("radio cut 1,3 2-4");
  EXPECT_EQ(pair.action(), kind::RADIO_OVERRIDE);
  EXPECT_EQ(pair.loss_probability(), 1.0);
  EXPECT_THAT(pair.robots(), ElementsAre(1, 3));
  EXPECT_THAT(pair.others(), ElementsAre(2, 3, 4));
  EXPECT_THAT(read("radio cut all at 5").robots(), IsEmpty());
  EXPECT_EQ(read("radio degrade 0.25 1").loss_probability(), 0.25);
  EXPECT_TRUE(std::isnan(read("radio heal 1 2").loss_probability()));
  const auto area = read("radio cut area -2 -1 3 4");
  EXPECT_TRUE(area.in_area());
  EXPECT_EQ(area.area_low_x_m(), -2.0);
  EXPECT_EQ(area.area_high_y_m(), 4.0);
  EXPECT_EQ(read("radio clear").action(), kind::RADIO_CLEAR);
}

TEST(ControlWords, SayWhatIsWrong) {
  EXPECT_THAT(error_of("hold"), HasSubstr("robot's number is missing"));
  EXPECT_THAT(error_of("hold zero"), HasSubstr("\"zero\" is not a robot's number"));
  EXPECT_THAT(error_of("teleport 1 nowhere 2"), HasSubstr("x must be a number"));
  EXPECT_THAT(error_of("teleport 1 nan 2"), HasSubstr("x must be a number"));
  EXPECT_THAT(error_of("pause now"), HasSubstr("one word too many"));
  const std::string range = "must be a whole number from 1 to 4294967295, is ";
  for (const std::string step : {"0", "4294967296", "99999999999999999", "99999999999999999999", "-1", "x"})
    EXPECT_EQ(error_of("pause at " + step), "the step after `at` " + range + "\"" + step + "\"");
  EXPECT_EQ(read("pause at 4294967295").at_step(), 4294967295U);
  EXPECT_THAT(error_of("radio melt 1"), HasSubstr("cut, degrade, heal or clear"));
  for (const char* loss : {"nan", "-0.1", "1.1", "much"})
    EXPECT_THAT(error_of("radio degrade " + std::string{loss} + " 1"), HasSubstr("from 0 to 1"));
  EXPECT_THAT(error_of("radio cut 1 1"), HasSubstr("no link to itself"));
  EXPECT_THAT(error_of("radio cut 4-2"), HasSubstr("is not a robot"));
  EXPECT_EQ(error_of("step 0"), "the number of steps " + range + "\"0\"");
  EXPECT_EQ(read_control(Words{split("fly 3")}), std::nullopt);
}

TEST(ControlWords, EveryFormInTheHelpCanBeRead) {
  for (const ControlForm& form : control_forms()) {
    std::vector<std::string> words;
    int number = 0;  // another one for each place: two sets of robots differ
    for (const std::string& word : split(std::string{form.form})) {
      const bool is_place = word.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") != std::string::npos;
      words.push_back(is_place ? std::to_string(++number) : word);
    }
    SCOPED_TRACE(std::string{form.form});
    EXPECT_TRUE(read_control(Words{words}));
  }
}

TEST(Split, KeepsQuotedWordsWhole) {
  EXPECT_THAT(split("log  robot \"starting from\" x"), ElementsAre("log", "robot", "starting from", "x"));
  EXPECT_THROW((void)split("\"open"), WordsError);
}

}  // namespace
}  // namespace caravan::deploy
