// SPDX-License-Identifier: Apache-2.0
// Ctrl-C in the launcher, many times.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "runtime/host/domain_lock.hpp"
#include "runtime/pure/random.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace {

using namespace std::chrono_literals;
using ::testing::IsEmpty;

TEST(InterruptLong, AHundredInterruptsAtRandomMomentsLeaveNothingBehind) {
  const std::uint64_t seed = 5;
  SCOPED_TRACE(seed);
  pure::Random random{seed};
  const runtime::DomainLock lock{std::nullopt};
  const ScratchFolder folder;
  for (int attempt = 0; attempt < 100; ++attempt) {
    const auto moment = std::chrono::milliseconds{static_cast<int>(random.uniform(5.0, 2000.0))};
    SCOPED_TRACE(attempt);
    SCOPED_TRACE(moment.count());
    Process caravan{{"caravan", "run", scenario("small.toml"), "--items", "1000", "--out",
                     folder / ("out" + std::to_string(attempt)), "--domain", std::to_string(lock.domain())},
                    folder / "caravan.log"};
    ASSERT_TRUE(caravan.runs_on_for(moment)) << caravan.output();
    caravan.signal(SIGINT);
    const auto code = caravan.wait(kPatience);
    ASSERT_TRUE(code == 130) << caravan.output();
    ASSERT_THAT(processes_in(lock.domain()), IsEmpty());
    ASSERT_THAT(left_in_shared_memory(lock.domain()), IsEmpty());
  }
}

}  // namespace
}  // namespace caravan::test
