// SPDX-License-Identifier: Apache-2.0
// Half an hour of runs of the paper's experiment with strangers in their domain: the digest is always the
// same.
#include <gtest/gtest.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "runtime/host/domain_lock.hpp"
#include "tests/system/support/digest_of.hpp"
#include "tests/system/support/process.hpp"
#include "tests/system/support/rogues.hpp"

namespace caravan::test {
namespace {

using namespace std::chrono_literals;

TEST(StrangersLong, ChangeNothingInHalfAnHourOfThePapersRuns) {
  constexpr auto kWhole = 30min;
  const std::string expected = digest_of("paper.toml", kEmbedded, {});
  const runtime::DomainLock lock{std::nullopt};
  const auto began = std::chrono::steady_clock::now();
  for (std::uint32_t seed = 1; std::chrono::steady_clock::now() - began < kWhole; seed += 4) {
    std::printf("rogues from seed %u on\n", seed);
    const ScratchFolder folder;
    Process caravan{{"caravan", "run", scenario("paper.toml"), "--quiet", "--out", folder / "out", "--domain",
                     std::to_string(lock.domain())},
                    folder / "caravan.log"};
    const Rogues rogues{{"rogue", "world_server", "radio_emulator", "robot_agent 1"},
                        {.domain = lock.domain(), .robots = 15, .rate = 100.0, .seed = seed},
                        folder.path()};
    ASSERT_EQ(caravan.wait(40min), 0) << caravan.output() << rogues.output();
    const auto metrics = nlohmann::json::parse(read_file(folder / "out/metrics.json"));
    ASSERT_EQ(metrics.at("digest"), expected);
    ASSERT_FALSE(metrics.at("disturbed"));
    EXPECT_FALSE(metrics.at("strangers").empty());
  }
}

}  // namespace
}  // namespace caravan::test
