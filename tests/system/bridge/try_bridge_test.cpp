// SPDX-License-Identifier: Apache-2.0
// deploy/try_bridge as a newcomer calls it, in a copy of the tree that uses the programs of this build. It
// runs in its own network namespace, so the domain that the test holds outside is free there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "build_paths.hpp"
#include "runtime/host/domain_lock.hpp"
#include "runtime/host/shared_memory.hpp"
#include "tests/system/support/bus_player.hpp"

namespace caravan::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr std::chrono::milliseconds kRunPatience{100'000};

class TryBridge : public ::testing::Test {
 protected:
  void SetUp() override {
    deploy::Process probe{in_namespace("true"), folder_ / "probe.log"};
    if (probe.wait(kPatience) != 0) GTEST_SKIP() << "no network namespaces here: " << probe.output();
    const fs::path source{CARAVAN_SOURCE_DIR};
    for (const char* part : {"deploy/scenarios", "cmake", "build/release"})
      fs::create_directories(folder_ / part);
    fs::copy_file(source / "deploy/try_bridge", folder_ / "deploy/try_bridge");
    fs::create_directory_symlink(CARAVAN_BIN_DIR, folder_ / "build/release/bin");
    // The packages are installed and the programs are built already.
    write_file(folder_ / "cmake/set_up.sh",
               "install_packages() { :; }\nbuild_preset() { echo build_preset $*; }\n");
    write_file(folder_ / "deploy/scenarios/one_robot.toml",
               read_file(source / "deploy/scenarios/one_robot.toml"));
  }
  void TearDown() override {
    for (const pid_t process : processes_in(lock_.domain()))
      kill(process, SIGTERM);  // left by a script that failed
  }
  [[nodiscard]] static std::vector<std::string> in_namespace(const std::string& script) {
    return {
        "/usr/bin/unshare", "--map-root-user", "--net", "/bin/sh", "-c", "ip link set lo up && " + script};
  }
  [[nodiscard]] std::vector<std::string> try_bridge(const std::string& options) const {
    return in_namespace("cd " + folder_.path().string() + " && exec deploy/try_bridge " + options);
  }
  [[nodiscard]] std::string on_domain() const { return "--domain " + std::to_string(lock_.domain()); }
  void expect_nothing_left() const {
    EXPECT_THAT(processes_in(lock_.domain()), IsEmpty());
    EXPECT_THAT(left_in_shared_memory(lock_.domain()), IsEmpty());
  }

  runtime::DomainLock lock_{std::nullopt};
  ScratchFolder folder_;
};

TEST_F(TryBridge, DrivesTheRobotUntilCtrlCAndLeavesNothingBehind) {
  deploy::Process script{try_bridge(on_domain()), folder_ / "script.log"};
  EXPECT_TRUE(
      script.prints("build_preset release world_server robot_agent pioneer_bridge arcos_robot", kPatience));
  EXPECT_TRUE(script.prints("robot connected: caravan_1, Pioneer p3dx", kRunPatience)) << script.output();
  EXPECT_TRUE(script.prints("started robots=1", kRunPatience)) << script.output();
  EXPECT_THAT(script.output(), Not(HasSubstr("tcp:127.0.0.1:8101"))) << "it takes ports that are free";
  script.signal(SIGINT);
  EXPECT_EQ(script.wait(kRunPatience), 130) << script.output();
  EXPECT_THAT(script.output(), AllOf(HasSubstr("\nstopping\n"), HasSubstr("\nlogs         /")));
  expect_nothing_left();
}

TEST_F(TryBridge, EndsWhenTheWorldHasFinished) {
  write_file(folder_ / "deploy/scenarios/one_robot.toml",
             replaced(read_file(folder_ / "deploy/scenarios/one_robot.toml"), "max_time_s = 1800.0",
                      "max_time_s = 3.0"));
  deploy::Process script{try_bridge(on_domain()), folder_ / "script.log"};
  EXPECT_EQ(script.wait(kRunPatience), 0) << script.output();
  EXPECT_THAT(script.output(), HasSubstr("\ndone         finished sim_s=3"));
  expect_nothing_left();
}

TEST_F(TryBridge, SaysWhichProgramHasEndedByItself) {
  deploy::Process script{try_bridge(on_domain()), folder_ / "script.log"};
  EXPECT_TRUE(script.prints("started robots=1", kRunPatience)) << script.output();
  kill(pid_in(lock_.domain(), "arcos_robot"), SIGTERM);
  EXPECT_EQ(script.wait(kRunPatience), 1);
  EXPECT_THAT(script.output(), HasSubstr("arcos_robot has ended by itself"));
  expect_nothing_left();
}

TEST_F(TryBridge, TellsItsOptions) {
  deploy::Process script{try_bridge("--help"), folder_ / "script.log"};
  EXPECT_EQ(script.wait(kPatience), 0);
  EXPECT_THAT(script.output(),
              AllOf(HasSubstr("usage: deploy/try_bridge [--domain N]"), HasSubstr("Ctrl-C")));
}

TEST_F(TryBridge, RefusesWhatItDoesNotKnow) {
  for (const char* options : {"--robots 3", "--domain 233", "--domain x", "--domain 7 --more"}) {
    deploy::Process script{try_bridge(options), folder_ / "script.log"};
    EXPECT_EQ(script.wait(kPatience), 2) << options;
  }
}

}  // namespace
}  // namespace caravan::test
