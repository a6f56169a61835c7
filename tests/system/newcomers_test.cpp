// SPDX-License-Identifier: Apache-2.0
// One process stays, the others are killed one after the other: whoever comes next must hear and be heard.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>

#include "deploy/launcher/domain_lock.hpp"
#include "deploy/launcher/shared_memory.hpp"
#include "robotPubSubTypes.h"
#include "runtime/bus/bus.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace {

namespace msg = caravan_interfaces::msg;
using namespace std::chrono_literals;
using ::testing::Contains;
using ::testing::EndsWith;
using ::testing::Not;

constexpr int kLives = 125;  // more than the 120 that a domain has room for at one time

/// A process of the test's own that does something and then stays; killed when this goes out of scope.
class Child {
 public:
  template <typename Body>
  explicit Child(Body body) : pid_{fork()} {
    if (pid_ != 0) return;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    body();
    _exit(1);
  }
  ~Child() {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  [[nodiscard]] pid_t pid() const { return pid_; }

 private:
  pid_t pid_;
};

[[noreturn]] void stay() {
  for (;;) pause();
}

/// Like a world: says something to everybody that comes, and notes on the pipe whoever answers.
void be_there(std::uint32_t domain, int pipe) {
  runtime::Bus bus{{.role = "world", .domain = domain}};
  auto sensors = bus.writer<msg::SensorFramePubSubType>(idl::kSensors, 1);
  bus.reader<msg::RobotCommandPubSubType>(
      idl::kCommand, 1, [pipe](const msg::RobotCommand&, const auto&) { (void)!write(pipe, "!", 1); });
  msg::SensorFrame frame;
  sensors.write(frame);
  stay();
}

/// Like a robot: answers.
void come(std::uint32_t domain) {
  runtime::Bus bus{{.role = "robot", .domain = domain}};
  auto commands = bus.writer<msg::RobotCommandPubSubType>(idl::kCommand, 1);
  bus.reader<msg::SensorFramePubSubType>(idl::kSensors, 1, [&](const msg::SensorFrame&, const auto&) {
    msg::RobotCommand command;
    commands.write(command);
  });
  stay();
}

TEST(Newcomers, AreHeardHoweverManyWereKilledBefore) {
  const deploy::DomainLock lock{std::nullopt};
  deploy::SharedMemory leftovers{lock.domain()};
  std::array<int, 2> pipe_ends{};
  ASSERT_EQ(pipe(pipe_ends.data()), 0);
  const Child resident{[&] { be_there(lock.domain(), pipe_ends[1]); }};
  const auto began = std::chrono::steady_clock::now();
  for (int life = 1; life <= kLives; ++life) {
    const Child newcomer{[&] { come(lock.domain()); }};
    pollfd answered{.fd = pipe_ends[0], .events = POLLIN, .revents = 0};
    ASSERT_EQ(poll(&answered, 1, 30'000), 1) << "newcomer " << life << " is not heard, or does not hear";
    char answer = 0;
    ASSERT_EQ(read(pipe_ends[0], &answer, 1), 1);
    leftovers.note(newcomer.pid());
  }
  std::printf("%d lives in %.1f s\n", kLives,
              std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
  // At a port with several readers the place of a killed one fills up, and hangs those that come when DDS
  // has looked at it.
  EXPECT_THAT(left_in_shared_memory(lock.domain()), Not(Contains(EndsWith("_sl"))));
  close(pipe_ends[0]);
  close(pipe_ends[1]);
}

}  // namespace
}  // namespace caravan::test
