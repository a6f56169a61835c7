// SPDX-License-Identifier: Apache-2.0
// Processes that end before their run has begun or immediately afterwards.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "build_paths.hpp"
#include "runtime/bus/shared_memory_port.hpp"
#include "runtime/host/domain_lock.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Half of the default `start_timeout_s`.
constexpr std::chrono::milliseconds kPatience{60'000};
const fs::path kPrograms{CARAVAN_BIN_DIR};

/// A folder with the launcher and the programs beside it, one of which a test replaces.
class EarlyEnd : public ::testing::Test {
 protected:
  EarlyEnd() {
    fs::create_directory(bin_);
    fs::copy_file(kPrograms / "caravan", bin_ / "caravan");
    for (const char* program : {"world_server", "radio_emulator", "robot_agent"})
      fs::create_symlink(kPrograms / program, bin_ / program);
  }
  void replace(const std::string& program, const std::string& script) const {
    fs::remove(bin_ / program);
    std::ofstream{bin_ / program} << "#!/bin/sh\n"
                                  << script << "\nexec " << (kPrograms / program).string() << " \"$@\"\n";
    fs::permissions(bin_ / program, fs::perms::owner_all);
  }
  void expect_failed_naming(const std::string& name, const std::string& how) {
    const std::vector<std::string> words{bin_ / "caravan", "run",      scenario("small.toml"),        "--out",
                                         folder_ / "out",  "--domain", std::to_string(lock_.domain())};
    deploy::Process launcher{words, folder_ / "launcher.log"};
    EXPECT_EQ(launcher.wait(kPatience), 2) << launcher.output();
    EXPECT_THAT(launcher.output(), HasSubstr("\n" + name + " (pid "));
    EXPECT_THAT(launcher.output(), HasSubstr(how + ", and the run had not begun"));
    EXPECT_THAT(processes_in(lock_.domain()), IsEmpty());
    EXPECT_THAT(left_in_shared_memory(lock_.domain()), IsEmpty());
  }

  runtime::DomainLock lock_{std::nullopt};
  ScratchFolder folder_;
  fs::path bin_ = folder_ / "bin";
};

TEST_F(EarlyEnd, OfAnAgentFailsTheRunAtOnceByItsName) {
  replace("robot_agent", "case \"$*\" in *\"--robot 3\"*) exit 7;; esac");
  expect_failed_naming("robot_agent_3", "ended with exit code 7, its log says why");
}

TEST_F(EarlyEnd, OfTheRadioFailsTheRunAtOnceByItsName) {
  replace("radio_emulator", "kill -9 $$");
  expect_failed_naming("radio_emulator",
                       "was killed by signal 9 (somebody did it, or the kernel for want of memory)");
}

TEST_F(EarlyEnd, OfTheWorldFailsTheRunAtOnceByItsName) {
  replace("world_server", "kill -11 $$");
  expect_failed_naming("world_server", "was ended by signal 11 (Segmentation fault), its log may say why");
}

std::vector<std::string> segments_of(pid_t pid) {
  std::vector<std::string> names;
  std::ifstream maps{"/proc/" + std::to_string(pid) + "/maps"};
  for (std::string line; std::getline(maps, line);) {
    const std::size_t place = line.find("/dev/shm/" + runtime::shared_memory_mark());
    if (place != std::string::npos && line.find("port") == std::string::npos)
      names.push_back(line.substr(place));
  }
  return names;
}

TEST(KilledWorld, LeavesNothingInSharedMemoryHoweverEarlyInTheRunItWas) {
  const runtime::DomainLock lock{std::nullopt};
  const ScratchFolder folder;
  Process launcher{{"caravan", "run", scenario("small.toml"), "--items", "100000", "--max-time", "1000000",
                    "--out", folder / "out", "--domain", std::to_string(lock.domain())},
                   folder / "launcher.log"};
  const auto has_begun = [&] {
    const std::string tracks = read_file(folder / "out/tracks.csv");
    return std::count(tracks.begin(), tracks.end(), '\n') > 4;
  };
  ASSERT_TRUE(eventually(has_begun, kPatience)) << launcher.output();
  const pid_t world = pid_in(lock.domain(), "world_server");
  const std::vector<std::string> segments = segments_of(world);
  ASSERT_FALSE(segments.empty());

  ASSERT_EQ(kill(world, SIGKILL), 0);

  EXPECT_EQ(launcher.wait(kPatience), 1) << launcher.output();
  EXPECT_THAT(launcher.output(), HasSubstr("world_server (pid "));
  for (const std::string& segment : segments) {
    EXPECT_FALSE(fs::exists(segment)) << segment;
    EXPECT_FALSE(fs::exists(segment + "_el")) << segment;
  }
  EXPECT_THAT(left_in_shared_memory(lock.domain()), IsEmpty());
}

}  // namespace
}  // namespace caravan::test
