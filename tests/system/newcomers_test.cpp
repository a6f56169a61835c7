// SPDX-License-Identifier: Apache-2.0
// One process stays while others are killed one after the other. Each newcomer must receive and be received.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>

#include "idl/robot_types.hpp"
#include "runtime/bus/bus.hpp"
#include "runtime/host/domain_lock.hpp"
#include "runtime/host/shared_memory.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace {

namespace msg = caravan_interfaces::msg;
using namespace std::chrono_literals;
using ::testing::Contains;
using ::testing::EndsWith;
using ::testing::Not;

/// A child process that runs `body`, which does not return. The destructor kills it.
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

/// Like a world: writes a sample for everyone that comes, and notes each answer on the pipe.
void be_there(const runtime::BusConfig& config, int pipe) {
  runtime::Bus bus{config};
  auto sensors = bus.writer<msg::SensorFramePubSubType>(idl::kSensors, 1);
  bus.reader<msg::RobotCommandPubSubType>(
      idl::kCommand, 1, [pipe](const msg::RobotCommand&, const auto&) { (void)!write(pipe, "!", 1); });
  msg::SensorFrame frame;
  sensors.write(frame);
  stay();
}

/// Like a robot: answers each sample.
void come(const runtime::BusConfig& config) {
  runtime::Bus bus{config};
  auto commands = bus.writer<msg::RobotCommandPubSubType>(idl::kCommand, 1);
  bus.reader<msg::SensorFramePubSubType>(idl::kSensors, 1, [&](const msg::SensorFrame&, const auto&) {
    msg::RobotCommand command;
    commands.write(command);
  });
  stay();
}

/// A process that stays, and what it receives.
class Newcomers : public ::testing::Test {
 protected:
  Newcomers() { EXPECT_EQ(pipe(pipe_.data()), 0); }
  ~Newcomers() override {
    close(pipe_[0]);
    close(pipe_[1]);
  }
  [[nodiscard]] runtime::BusConfig config(const char* role) const {
    return {.role = role, .domain = lock_.domain(), .lease_s = lease_s_, .transport = transport_};
  }
  /// Starts this number of newcomers, one after the other, and kills each when its answer has come.
  void come_and_go(int lives) {
    const Child resident{[&] { be_there(config("world"), pipe_[1]); }};
    const auto began = std::chrono::steady_clock::now();
    for (int life = 1; life <= lives; ++life) {
      const Child newcomer{[&] { come(config("robot")); }};
      pollfd answered{.fd = pipe_[0], .events = POLLIN, .revents = 0};
      ASSERT_TRUE(eventually([&] { return poll(&answered, 1, 20) == 1; }, kPatience))
          << "newcomer " << life << " is not heard, or does not hear";
      char answer = 0;
      ASSERT_EQ(read(pipe_[0], &answer, 1), 1);
      leftovers_.note(newcomer.pid());
    }
    leftovers_.note(resident.pid());
    std::printf("%d lives in %.1f s\n", lives,
                std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
  }

  const runtime::DomainLock lock_{std::nullopt};
  runtime::SharedMemory leftovers_{lock_.domain()};
  double lease_s_ = 5.0;
  runtime::Transport transport_ = runtime::Transport::kSharedMemory;

 private:
  std::array<int, 2> pipe_{};
};

TEST_F(Newcomers, AreHeardHoweverManyWereKilledBefore) {
  come_and_go(125);  // more than the 120 that a domain on UDP has room for
  // If a port had several readers, the segment of a killed one would fill up and block newcomers once DDS has
  // looked at it.
  EXPECT_THAT(left_in_shared_memory(lock_.domain()), Not(Contains(EndsWith("_sl"))));
}

TEST_F(Newcomers, AreHeardAtOnceAndNotAtTheNextAnnouncement) {
  transport_ = runtime::Transport::kUdp;
  lease_s_ = 1000.0;  // the next announcement comes after 400 s, longer than the test waits
  come_and_go(12);
}

}  // namespace
}  // namespace caravan::test
