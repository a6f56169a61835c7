// SPDX-License-Identifier: Apache-2.0
#include "experiment/sweep/sweep_progress.hpp"

#include <gtest/gtest.h>

#include <array>

namespace caravan::experiment {
namespace {

TEST(TimeLeft, SharesTheWorkAmongTheJobs) {
  EXPECT_EQ(time_left_s(10.0, 4, {}, 2), 20.0);
  EXPECT_EQ(time_left_s(10.0, 3, std::array{4.0, 10.0}, 2), 18.0);
}

TEST(TimeLeft, IsNotLessThanOneRunNeedsAlone) {
  EXPECT_EQ(time_left_s(10.0, 1, {}, 8), 10.0);
  EXPECT_EQ(time_left_s(10.0, 0, std::array{4.0, 1.0}, 8), 9.0);
}

TEST(TimeLeft, IsNothingForRunsThatTakeLongerThanOthersDid) {
  EXPECT_EQ(time_left_s(10.0, 0, std::array{11.0}, 2), 0.0);
}

TEST(ProgressBar, TellsWhatIsDoneFailedRunningAndLeft) {
  EXPECT_EQ(progress_bar({.total = 90, .done = 22, .failed = 1, .running = 2, .left_s = 760.0}),
            "[#####...............] 23 of 90, 1 failed, 2 running, 12:40 left");
  EXPECT_EQ(progress_bar({.total = 4, .done = 0, .failed = 0, .running = 2, .left_s = {}}),
            "[....................] 0 of 4, 2 running");
  EXPECT_EQ(progress_bar({.total = 4, .done = 4, .failed = 0, .running = 0, .left_s = {}}),
            "[####################] 4 of 4");
}

}  // namespace
}  // namespace caravan::experiment
