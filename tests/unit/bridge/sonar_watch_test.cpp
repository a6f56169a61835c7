// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "hardware_bridge/core/host/sonar_watch.hpp"

namespace caravan::bridge {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Sonars : public ::testing::Test {
 protected:
  /// Two of sixteen sonars every 40 ms, as on a Pioneer; those in `zero` read 0.
  void run(Time span, const std::vector<std::size_t>& zero) {
    for (const Time end = now_ + span; now_ < end; now_ += 40ms, next_ = (next_ + 1) % 8) {
      std::vector<arcos::Sip::Sonar> readings;
      for (const std::size_t index : {next_, next_ + 8}) {
        const bool reads_zero = std::find(zero.begin(), zero.end(), index) != zero.end();
        readings.push_back(
            {static_cast<std::uint8_t>(index), static_cast<std::uint16_t>(reads_zero ? 0 : 1200)});
      }
      hear(readings);
    }
  }
  void hear(const std::vector<arcos::Sip::Sonar>& readings) {
    for (const Notice& notice : watch_.watch(readings, now_)) told_.push_back(notice.text);
  }
  SonarWatch watch_;
  Time now_{0};
  std::size_t next_ = 0;
  std::vector<std::string> told_;
};

TEST_F(Sonars, ThatMeasureAreNotTold) {
  run(10s, {});
  EXPECT_THAT(told_, IsEmpty());
}

TEST_F(Sonars, OneThatReadsZeroIsNamedOnceAndSoIsItsEnd) {
  run(2s, {});
  run(1s, {12});
  EXPECT_THAT(told_, IsEmpty()) << "a hand before it is no defect";
  run(10s, {12});
  EXPECT_THAT(told_, ElementsAre(HasSubstr("sonar 12 reads 0 mm all the time")));
  run(2s, {});
  EXPECT_THAT(told_, ElementsAre(HasSubstr("sonar 12"), HasSubstr("measure again")));
}

TEST_F(Sonars, SeveralAreNamedInOneLine) {
  run(10s, {3, 4, 15});
  EXPECT_THAT(told_, ElementsAre(HasSubstr("sonars 3, 4, 15 read 0 mm")));
}

TEST_F(Sonars, AllAreCalledSo) {
  std::vector<std::size_t> all(16);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  run(10s, all);
  EXPECT_THAT(told_, ElementsAre(HasSubstr("all sonars read 0 mm")));
}

TEST_F(Sonars, ThatGiveNoReadingsAreTold) {
  run(1s, {});
  for (const Time end = now_ + 10s; now_ < end; now_ += 100ms) hear({});
  EXPECT_THAT(told_, ElementsAre(HasSubstr("sonars give no readings")));
  run(1s, {});
  EXPECT_THAT(told_, ElementsAre(HasSubstr("sonars give no readings"), "the sonars give readings again"));
}

}  // namespace
}  // namespace caravan::bridge
