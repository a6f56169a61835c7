// SPDX-License-Identifier: Apache-2.0
#include "deploy/sweep/seeds.hpp"

#include <gmock/gmock.h>

#include "runtime/config/start_error.hpp"

namespace caravan::deploy {
namespace {

using runtime::StartError;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Seeds, AreNumbersAndRangesInAscendingOrderEachOnce) {
  EXPECT_THAT(read_seeds("7"), ElementsAre(7));
  EXPECT_THAT(read_seeds("1-4"), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(read_seeds("9,1-3,2-4"), ElementsAre(1, 2, 3, 4, 9));
  EXPECT_THAT(read_seeds("5-5"), ElementsAre(5));
  EXPECT_THAT(read_seeds("0,9223372036854775807"), ElementsAre(0, 9223372036854775807ULL));
  EXPECT_THAT(read_seeds("9223372036854775806-9223372036854775807"), testing::SizeIs(2));
}

TEST(Seeds, OfNonsenseAreRefusedWithTheReason) {
  for (const std::string text : {"", "a", "1-", "-1", "1-2-3", "1,,2", "1 - 3", "1-3,", "1.5", "+1"}) {
    EXPECT_THAT([&] { (void)read_seeds(text); },
                ThrowsMessage<StartError>(HasSubstr("--seeds " + text + ": is not a list of seeds")))
        << text;
  }
  EXPECT_THAT([] { (void)read_seeds("3-1"); }, ThrowsMessage<StartError>(HasSubstr("3-1 runs backwards")));
  EXPECT_THAT([] { (void)read_seeds("9223372036854775808"); },
              ThrowsMessage<StartError>(HasSubstr("at most 9223372036854775807")));
  EXPECT_THAT([] { (void)read_seeds("99999999999999999999"); },
              ThrowsMessage<StartError>(HasSubstr("at most 9223372036854775807")));
}

TEST(Seeds, AreNotMoreThanAnybodyMeans) {
  EXPECT_THAT(read_seeds("1-100000"), testing::SizeIs(kMostSeeds));
  EXPECT_THAT([] { (void)read_seeds("0-9223372036854775807"); },
              ThrowsMessage<StartError>(HasSubstr("more than")));
  EXPECT_THAT([] { (void)read_seeds("1-100000,200000"); }, ThrowsMessage<StartError>(HasSubstr("more than")));
}

TEST(Modes, KeepTheOrderGiven) {
  EXPECT_THAT(read_modes("full,none"), ElementsAre("full", "none"));
  EXPECT_THAT(read_modes("partial"), ElementsAre("partial"));
}

TEST(Modes, ThatAreNoneOrTwiceThereAreRefused) {
  EXPECT_THAT([] { (void)read_modes("none,loud"); }, ThrowsMessage<StartError>(HasSubstr("\"loud\" is not")));
  EXPECT_THAT([] { (void)read_modes(""); }, ThrowsMessage<StartError>(HasSubstr("\"\" is not")));
  EXPECT_THAT([] { (void)read_modes("full,none,full"); }, ThrowsMessage<StartError>(HasSubstr("full twice")));
}

}  // namespace
}  // namespace caravan::deploy
