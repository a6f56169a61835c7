// SPDX-License-Identifier: Apache-2.0
// A DDS domain that a run holds is refused to everyone else, whichever user they are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "build_paths.hpp"
#include "runtime/host/domain_lock.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace {

using namespace std::chrono_literals;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr std::chrono::milliseconds kPatience{60'000};

class TakenDomain : public ::testing::Test {
 protected:
  struct Ended {
    std::optional<int> code;
    std::string said;
  };
  void SetUp() override {
    ASSERT_TRUE(first_.prints("DDS domain ", kPatience)) << first_.output();
    const std::string said = first_.output();
    domain_ = std::to_string(std::strtoul(said.c_str() + said.find("DDS domain ") + 11, nullptr, 10));
  }
  void TearDown() override {
    EXPECT_EQ(first_.wait(0ms), std::nullopt) << "the first run goes on: " << first_.output();
    first_.signal(SIGINT);
    EXPECT_EQ(first_.wait(kPatience), 130) << first_.output();
    const auto metrics = nlohmann::json::parse(read_file(folder_ / "first/metrics.json"));
    EXPECT_FALSE(metrics.at("disturbed"));
  }
  Ended end_of(std::vector<std::string> words) const {
    deploy::Process process{std::move(words), folder_ / "other.log"};
    const auto code = process.wait(kPatience);
    return {code, process.output()};
  }
  static std::string caravan() { return std::string{CARAVAN_BIN_DIR} + "/caravan"; }
  /// The command run by another user.
  static std::vector<std::string> as_nobody(std::vector<std::string> words) {
    words.insert(words.begin(), {"/usr/bin/setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"});
    return words;
  }
  bool can_be_nobody() const {
    return geteuid() == 0 && end_of(as_nobody({caravan(), "check", scenario("small.toml")})).code == 0;
  }

  ScratchFolder folder_;
  Process first_{{"caravan", "run", scenario("small.toml"), "--items", "100000", "--max-time", "1000000",
                  "--out", folder_ / "first"},
                 folder_ / "first.log"};
  std::string domain_;
};

TEST_F(TakenDomain, IsRefusedToARunAndToADeploymentNamingWhoHoldsItAndNothingIsLeft) {
  const std::filesystem::path script = std::string{CARAVAN_SOURCE_DIR} + "/deploy/scripts/robot_killed.toml";
  for (const std::vector<std::string>& words : {std::vector<std::string>{"run", scenario("small.toml")},
                                                std::vector<std::string>{"deploy", script}}) {
    std::vector<std::string> line{caravan()};
    line.insert(line.end(), words.begin(), words.end());
    line.insert(line.end(), {"--domain", domain_, "--out", folder_ / "second"});
    line.insert(line.begin(), {"/usr/bin/env", "TMPDIR=/nowhere"});
    const Ended second = end_of(line);
    EXPECT_EQ(second.code, 2);
    EXPECT_THAT(second.said,
                AllOf(HasSubstr("DDS domain " + domain_), HasSubstr("another run or world holds it"),
                      HasSubstr("pid " + std::to_string(first_.pid()) + ","), HasSubstr("since ")));
    EXPECT_EQ(std::count(second.said.begin(), second.said.end(), '\n'), 1) << second.said;
    EXPECT_TRUE(!std::filesystem::exists(folder_ / "second") ||
                std::filesystem::is_empty(folder_ / "second"));
  }
}

TEST_F(TakenDomain, IsNotGivenToARunThatWantsAnyWhateverItsFolderOfTemporaryFiles) {
  const Ended second = end_of({"/usr/bin/env", "TMPDIR=/nowhere", caravan(), "run", scenario("small.toml"),
                               "--out", folder_ / "second"});
  EXPECT_EQ(second.code, 0) << second.said;
  EXPECT_THAT(second.said, ::testing::Not(HasSubstr("DDS domain " + domain_ + ",")));
}

TEST_F(TakenDomain, OfAnotherUserIsToldToBeThatUsers) {
  if (!can_be_nobody())
    GTEST_SKIP() << "only root can be somebody else, where the program may be read by all";
  const Ended ctl = end_of(as_nobody({caravan(), "ctl", "--domain", domain_, "status"}));
  EXPECT_EQ(ctl.code, 1);
  EXPECT_THAT(ctl.said, HasSubstr("another user's (root)"));
  const Ended run = end_of(
      as_nobody({caravan(), "run", scenario("small.toml"), "--domain", domain_, "--out", "/tmp/nobodys"}));
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.said, HasSubstr("user root"));
  EXPECT_FALSE(std::filesystem::exists("/tmp/nobodys"));
}

/// The two worlds run in their own network namespace, where locks held outside do not count.
TEST(WorldByHand, HoldsItsDomainAgainstAnotherWorld) {
  const ScratchFolder folder;
  const runtime::DomainLock lock{std::nullopt};  // held outside that namespace
  const std::uint32_t domain = lock.domain();
  const std::string world = std::string{CARAVAN_BIN_DIR} + "/world_server --domain " +
                            std::to_string(domain) + " --scenario " + scenario("small.toml").string();
  const auto in_namespace = [](const std::string& script) {
    return std::vector<std::string>{
        "/usr/bin/unshare", "--map-root-user", "--net", "/bin/bash", "-c", script};
  };
  if (deploy::Process probe{in_namespace("true"), folder / "probe.log"}; probe.wait(kPatience) != 0)
    GTEST_SKIP() << "no network namespaces here: " << probe.output();
  deploy::Process two{
      in_namespace(world + " & a=$!; " + world + " & b=$!; wait -n; code=$?; kill $a $b; wait; exit $code"),
      folder / "two.log"};
  EXPECT_EQ(two.wait(kPatience), 2) << two.output();
  EXPECT_THAT(two.output(), HasSubstr("another run or world holds it (pid "));
}

TEST_F(TakenDomain, IsRefusedToAWorldThatIsStartedByHand) {
  const Ended world = end_of({std::string{CARAVAN_BIN_DIR} + "/world_server", "--domain", domain_,
                              "--scenario", scenario("small.toml")});
  EXPECT_EQ(world.code, 2) << world.said;
  EXPECT_THAT(world.said,
              HasSubstr("another run or world holds it (pid " + std::to_string(first_.pid()) + ","));
}

}  // namespace
}  // namespace caravan::test
