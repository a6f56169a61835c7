// SPDX-License-Identifier: Apache-2.0
// Runs over UDP complete, and send nothing off the machine.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "runtime/bus/shared_memory_port.hpp"
#include "runtime/host/domain_lock.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace {

using namespace std::chrono_literals;
using ::testing::Each;
using ::testing::IsEmpty;
using ::testing::Not;

/// Inodes of the sockets of a process.
std::set<std::string> sockets_of(pid_t pid) {
  std::set<std::string> inodes;
  std::error_code error;
  for (const auto& entry :
       std::filesystem::directory_iterator{"/proc/" + std::to_string(pid) + "/fd", error}) {
    const std::string target = std::filesystem::read_symlink(entry.path(), error);
    if (target.starts_with("socket:[")) inodes.insert(target.substr(8, target.size() - 9));
  }
  return inodes;
}

/// Local addresses of the UDP sockets among these inodes, in the notation of /proc/net.
std::vector<std::string> udp_addresses(const std::set<std::string>& inodes) {
  std::vector<std::string> addresses;
  for (const char* table : {"/proc/net/udp", "/proc/net/udp6"}) {
    std::istringstream lines{read_file(table)};
    for (std::string line; std::getline(lines, line);) {
      std::istringstream fields{line};
      std::vector<std::string> words;
      for (std::string word; fields >> word;) words.push_back(word);
      if (words.size() > 9 && inodes.contains(words[9]))
        addresses.push_back(words[1].substr(0, words[1].find(':')));
    }
  }
  return addresses;
}

class UdpRun : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> run(std::vector<std::string> options) const {
    std::vector<std::string> line{"caravan", "run",           scenario("small.toml"),
                                  "--out",   folder_ / "out", "--transport",
                                  "udp",     "--domain",      std::to_string(lock_.domain())};
    line.insert(line.end(), options.begin(), options.end());
    return line;
  }
  runtime::DomainLock lock_{std::nullopt};
  ScratchFolder folder_;
};

TEST_F(UdpRun, ListensAndSendsOnLoopbackOnlyAndSharesNoMemory) {
  Process caravan{run({"--items", "1000", "--max-time", "1500"}), folder_ / "caravan.log"};
  ASSERT_TRUE(eventually(
      [&] { return read_file(folder_ / "out/events.csv").find("delivery") != std::string::npos; }, 60s))
      << caravan.output();
  const std::vector<pid_t> pids = processes_in(lock_.domain());
  EXPECT_EQ(pids.size(), 7U) << "launcher, world, radio and four agents";
  for (const pid_t pid : pids) {
    SCOPED_TRACE(read_file("/proc/" + std::to_string(pid) + "/cmdline"));
    const std::vector<std::string> addresses = udp_addresses(sockets_of(pid));
    EXPECT_THAT(addresses, Not(IsEmpty()));
    EXPECT_THAT(addresses, Each("0100007F"));
    EXPECT_EQ(addresses.size(), 3U) << "two to receive, one to send; a launcher's are not its children's";
    EXPECT_EQ(
        read_file("/proc/" + std::to_string(pid) + "/maps").find("/dev/shm/" + runtime::shared_memory_mark()),
        std::string::npos);
  }
  Process ctl{{"caravan", "ctl", "--domain", std::to_string(lock_.domain()), "--transport", "udp", "status"},
              folder_ / "ctl.log"};
  EXPECT_EQ(ctl.wait(20s), 0) << ctl.output();
  EXPECT_EQ(ctl.output().find("running"), 0U) << ctl.output();
  caravan.signal(SIGINT);
  EXPECT_EQ(caravan.wait(10s), 130) << caravan.output();
  EXPECT_THAT(processes_in(lock_.domain()), IsEmpty());
}

TEST_F(UdpRun, FindsMoreProcessesThanDdsLooksForByItself) {
  Process caravan{run({"--robots", "8", "--items", "0", "--max-time", "2"}), folder_ / "caravan.log"};
  EXPECT_EQ(caravan.wait(60s), 0) << caravan.output();
  EXPECT_FALSE(nlohmann::json::parse(read_file(folder_ / "out/metrics.json")).at("disturbed"));
}

}  // namespace
}  // namespace caravan::test
