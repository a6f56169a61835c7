// SPDX-License-Identifier: Apache-2.0
#include "experiment/sweep/modes.hpp"

#include <gmock/gmock.h>

#include "runtime/config/start_error.hpp"

namespace caravan::experiment {
namespace {

using runtime::StartError;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

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
}  // namespace caravan::experiment
