// SPDX-License-Identifier: Apache-2.0
// The unit files of deploy/systemd, and the notifications of the programs to a service manager.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <regex>

#include "build_paths.hpp"
#include "runtime/host/domain_lock.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// The units as installed, but with the programs of this build.
class Units : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(kAnalyze)) GTEST_SKIP() << "no " << kAnalyze << " here";
    for (const auto& entry : fs::directory_iterator{fs::path{CARAVAN_SOURCE_DIR} / "deploy/systemd"}) {
      if (entry.path().extension() != ".service") continue;
      const std::string text =
          std::regex_replace(read_file(entry.path()), std::regex{"/opt/caravan/bin"}, CARAVAN_BIN_DIR);
      write_file(folder_ / entry.path().filename().string(), text);
      units_.push_back(folder_ / entry.path().filename().string());
    }
    ASSERT_EQ(units_.size(), 4U) << "world, radio, discovery, agent";
  }
  /// @return the exit code
  int analyze(std::vector<std::string> words, std::string& said) {
    words.insert(words.begin(), kAnalyze);
    PatientProcess process{words, folder_ / "analyze.log"};
    const auto code = process.wait(60s);
    said = process.output();
    return code.value_or(-1);
  }
  static constexpr const char* kAnalyze = "/usr/bin/systemd-analyze";
  ScratchFolder folder_;
  std::vector<std::string> units_;
};

TEST_F(Units, AreWhatSystemdUnderstands) {
  for (const std::string& unit : units_) {
    std::string said;
    EXPECT_EQ(analyze({"verify", "--man=no", "--recursive-errors=no", unit}, said), 0) << unit << "\n"
                                                                                       << said;
    EXPECT_EQ(said, "") << unit;
  }
}

TEST_F(Units, AreFoundWantingWhenTheirProgramIsMissingOrAKeyIsMisspelt) {
  std::string said;
  const std::string good = read_file(units_[0]);
  write_file(folder_ / "bad.service",
             std::regex_replace(good, std::regex{"ExecStart=[^ ]*"}, "ExecStart=/nowhere"));
  EXPECT_NE(analyze({"verify", "--man=no", folder_ / "bad.service"}, said), 0);
  write_file(folder_ / "bad.service", replaced(good, "Restart=", "Restrat="));
  (void)analyze({"verify", "--man=no", folder_ / "bad.service"}, said);
  EXPECT_THAT(said, HasSubstr("Restrat"));
}

TEST_F(Units, AllowTheProgramsLittleElseThanTheyNeed) {
  for (const std::string& unit : units_) {
    std::string said;
    EXPECT_EQ(analyze({"security", "--offline=yes", "--threshold=25", unit}, said), 0) << unit << "\n"
                                                                                       << said;
  }
}

/// The test in place of the service manager.
class Service : public ::testing::Test {
 protected:
  Service() {
    const std::string path = folder_ / "notify";
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path, path.data(), path.size());
    socket_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    EXPECT_EQ(bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }
  ~Service() override { close(socket_); }
  /// Starts a program as its unit does.
  [[nodiscard]] std::unique_ptr<PatientProcess> start(std::vector<std::string> line) const {
    std::vector<std::string> words{"/usr/bin/env", "NOTIFY_SOCKET=" + (folder_ / "notify").string(),
                                   "WATCHDOG_USEC=500000"};
    line[0] = std::string{CARAVAN_BIN_DIR} + "/" + line[0];
    words.insert(words.end(), line.begin(), line.end());
    words.insert(words.end(),
                 {"--scenario", scenario("small.toml"), "--domain", std::to_string(lock_.domain())});
    return std::make_unique<PatientProcess>(words, folder_ / "service.log");
  }
  /// The next message; empty if none comes.
  [[nodiscard]] std::string next() const {
    pollfd one{socket_, POLLIN, 0};
    if (!eventually([&] { return poll(&one, 1, 20) == 1; }, kPatience)) return "";
    std::array<char, 256> text{};
    const ssize_t size = recv(socket_, text.data(), text.size(), 0);
    return size < 0 ? "" : std::string{text.data(), static_cast<std::size_t>(size)};
  }

 private:
  ScratchFolder folder_;
  runtime::DomainLock lock_{std::nullopt};
  int socket_ = -1;
};

class EachProgram : public Service, public ::testing::WithParamInterface<std::vector<std::string>> {};

TEST_P(EachProgram, SaysThatItIsReadyAliveAndStopping) {
  const auto process = start(GetParam());
  EXPECT_EQ(next(), "READY=1") << process->output();
  for (int time = 0; time < 3; ++time) EXPECT_EQ(next(), "WATCHDOG=1") << process->output();
  process->signal(SIGTERM);
  std::string last = next();
  while (last == "WATCHDOG=1") last = next();
  EXPECT_EQ(last, "STOPPING=1") << process->output();
  EXPECT_EQ(process->wait(20s), 0) << process->output();
}

INSTANTIATE_TEST_SUITE_P(Programs, EachProgram,
                         ::testing::Values(std::vector<std::string>{"world_server"},
                                           std::vector<std::string>{"radio_emulator"},
                                           std::vector<std::string>{"robot_agent", "--robots", "3"}),
                         [](const auto& one) { return one.param[0]; });

}  // namespace
}  // namespace caravan::test
