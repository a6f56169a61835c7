// SPDX-License-Identifier: Apache-2.0
// A run with strangers in its domain that write forged and corrupted samples on every topic. It gives the
// result that it gives without them, and reports them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "runtime/host/domain_lock.hpp"
#include "tests/system/support/digest_of.hpp"
#include "tests/system/support/process.hpp"
#include "tests/system/support/rogues.hpp"

namespace caravan::test {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::chrono::milliseconds kRunPatience{150'000};

class Strangers : public ::testing::Test {
 protected:
  /// Runs small.toml beside one rogue for each of `roles`.
  nlohmann::json run_beside(const std::vector<std::string>& roles, std::vector<std::string> options = {}) {
    std::vector<std::string> line{"caravan",       "run",      scenario("small.toml"),        "--out",
                                  folder_ / "out", "--domain", std::to_string(lock_.domain())};
    line.insert(line.end(), options.begin(), options.end());
    Process caravan{line, folder_ / "caravan.log"};
    const Rogues rogues{roles, {.domain = lock_.domain(), .robots = 4, .rate = 400.0}, folder_.path()};
    EXPECT_EQ(caravan.wait(kRunPatience), 0) << caravan.output() << rogues.output();
    EXPECT_TRUE(rogues.have_all_begun()) << rogues.output();
    output_ = caravan.output();
    return nlohmann::json::parse(read_file(folder_ / "out/metrics.json"));
  }
  [[nodiscard]] std::string log_of(const std::string& process) const {
    return read_file(folder_ / ("out/logs/" + process + ".log"));
  }

  runtime::DomainLock lock_{std::nullopt};
  ScratchFolder folder_;
  std::string output_;
};

TEST_F(Strangers, ChangeNothingAndAreToldWhateverTheyState) {
  const auto metrics = run_beside({"rogue", "world_server", "radio_emulator", "robot_agent 1"});

  EXPECT_EQ(metrics.at("digest"), digest_of("small.toml", kEmbedded, {}));
  EXPECT_FALSE(metrics.at("disturbed"));
  const std::vector<std::string> strangers = metrics.at("strangers");
  EXPECT_THAT(strangers, Contains(AllOf(HasSubstr("world: "), HasSubstr("rogue pid"))));
  EXPECT_THAT(strangers, Contains(AllOf(HasSubstr("radio: "), HasSubstr("world_server pid"))));
  // How soon the launcher reads what each of the four writes depends on the load of the machine.
  EXPECT_THAT(strangers, Contains(HasSubstr("launcher: ")));
  EXPECT_THAT(output_, HasSubstr("stranger    world: "));
  EXPECT_THAT(log_of("robot_agent_1"), HasSubstr("sample refused topic=rt/robot_1/sensors"));
}

TEST_F(Strangers, AreNoneInARunOfItsOwn) {
  const auto metrics = run_beside({});

  EXPECT_EQ(metrics.at("digest"), digest_of("small.toml", kEmbedded, {}));
  EXPECT_THAT(metrics.at("strangers"), IsEmpty());
}

}  // namespace
}  // namespace caravan::test
