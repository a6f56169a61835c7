// SPDX-License-Identifier: Apache-2.0
// The messages of a process to a service manager such as systemd.
#include "runtime/process/service_manager.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <cstring>

#include "runtime/process/loop.hpp"

namespace caravan::runtime {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

/// The test in place of the service manager: an abstract socket of this process.
class ServiceManager : public testing::Test {
 protected:
  ServiceManager() {
    const std::string name = "caravan-test-" + std::to_string(getpid());
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path + 1, name.data(), name.size());
    socket_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
    EXPECT_EQ(bind(socket_, reinterpret_cast<const sockaddr*>(&address), length), 0);
    setenv("NOTIFY_SOCKET", ("@" + name).c_str(), 1);
  }
  ~ServiceManager() override {
    close(socket_);
    unsetenv("NOTIFY_SOCKET");
    unsetenv("WATCHDOG_USEC");
  }
  /// The messages since the last call.
  [[nodiscard]] std::vector<std::string> heard() const {
    std::vector<std::string> all;
    std::array<char, 256> text{};
    for (;;) {
      const ssize_t size = recv(socket_, text.data(), text.size(), MSG_DONTWAIT);
      if (size < 0) return all;
      all.emplace_back(text.data(), static_cast<std::size_t>(size));
    }
  }

 private:
  int socket_ = -1;
};

WallTime now() { return std::chrono::steady_clock::now(); }

TEST_F(ServiceManager, HearsOnceThatTheProcessIsReadyWhenItFirstWaits) {
  Loop loop;
  EXPECT_THAT(heard(), IsEmpty());
  EXPECT_EQ(loop.wait(now()), Loop::Woken::kDeadline);
  EXPECT_THAT(heard(), ElementsAre("READY=1"));
  EXPECT_EQ(loop.wait(now()), Loop::Woken::kDeadline);
  EXPECT_THAT(heard(), IsEmpty());
}

TEST_F(ServiceManager, HearsThatTheProcessIsStopping) {
  Loop loop;
  loop.stop();
  EXPECT_EQ(loop.wait(std::nullopt), Loop::Woken::kStop);
  EXPECT_THAT(heard(), ElementsAre("READY=1", "STOPPING=1"));
}

TEST_F(ServiceManager, HearsThatTheCallerIsAliveOnlyWhenItComesBack) {
  setenv("WATCHDOG_USEC", "2000", 1);
  Loop loop;
  EXPECT_EQ(loop.wait(std::nullopt), Loop::Woken::kNotified) << "half of the period is over";
  EXPECT_THAT(heard(), ElementsAre("READY=1", "WATCHDOG=1"));
  EXPECT_EQ(loop.wait(std::nullopt), Loop::Woken::kNotified);
  EXPECT_THAT(heard(), ElementsAre("WATCHDOG=1"));
}

TEST_F(ServiceManager, DoesNotChangeWhatTheCallerWaitsFor) {
  setenv("WATCHDOG_USEC", "600000000", 1);
  Loop loop;
  EXPECT_EQ(loop.wait(now()), Loop::Woken::kDeadline);
  loop.notify();
  EXPECT_EQ(loop.wait(std::nullopt), Loop::Woken::kNotified);
  loop.stop();
  EXPECT_EQ(loop.wait(std::nullopt), Loop::Woken::kStop);
}

TEST_F(ServiceManager, MayBeAbsent) {
  unsetenv("NOTIFY_SOCKET");
  tell_service_manager("READY=1");
  setenv("NOTIFY_SOCKET", "/nowhere/at/all", 1);
  tell_service_manager("READY=1");
  EXPECT_THAT(heard(), IsEmpty());
}

TEST_F(ServiceManager, IsAskedForItsPeriod) {
  EXPECT_EQ(watchdog_period(), std::nullopt);
  setenv("WATCHDOG_USEC", "20000000", 1);
  EXPECT_EQ(watchdog_period(), 20s);
  for (const char* nonsense : {"", "soon", "-5", "0", "10 s"}) {
    setenv("WATCHDOG_USEC", nonsense, 1);
    EXPECT_EQ(watchdog_period(), std::nullopt) << nonsense;
  }
}

}  // namespace
}  // namespace caravan::runtime
