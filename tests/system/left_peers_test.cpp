// SPDX-License-Identifier: Apache-2.0
// Peers that leave in every way cost those that stay nothing but memory.
//
// The cost of a resident is its processor time. Endless futile attempts to read what a peer has left would
// take up to a whole core; an idle resident takes less than a hundredth of one.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "idl/robot_types.hpp"
#include "runtime/bus/bus.hpp"
#include "runtime/bus/place.hpp"
#include "runtime/host/domain_lock.hpp"
#include "runtime/host/shared_memory.hpp"
#include "tests/support/patience.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace {

namespace msg = caravan_interfaces::msg;
using namespace std::chrono_literals;

/// A participant in a process of its own. It writes "+" to a pipe for each other participant that it finds,
/// and "-" for each that leaves.
class Peer {
 public:
  explicit Peer(std::uint32_t domain, double lease_s = 5.0) {
    EXPECT_EQ(pipe(pipe_.data()), 0);
    pid_ = fork();
    if (pid_ == 0) live(domain, lease_s);
    close(pipe_[1]);
  }
  ~Peer() {
    kill(SIGTERM);  // not SIGKILL, which would leave its segment in shared memory
    close(pipe_[0]);
  }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  [[nodiscard]] pid_t pid() const { return pid_; }
  void signal(int number) const { ::kill(pid_, number); }
  /// Ends the process and waits for its end.
  void kill(int number) {
    if (pid_ <= 0) return;
    ::kill(pid_, number);
    ::kill(pid_, SIGCONT);
    waitpid(pid_, nullptr, 0);
    pid_ = -1;
  }
  /// Waits until it has found another participant.
  void await_other() {
    char one = 0;
    while (one != '+') {
      pollfd news{.fd = pipe_[0], .events = POLLIN, .revents = 0};
      ASSERT_EQ(poll(&news, 1, static_cast<int>(kPatience.count())), 1) << "it finds nobody";
      ASSERT_EQ(read(pipe_[0], &one, 1), 1) << "it has died";
    }
  }
  /// Forgets the participants found so far.
  void forget_others() const {
    const int flags = fcntl(pipe_[0], F_GETFL);
    fcntl(pipe_[0], F_SETFL, flags | O_NONBLOCK);
    for (char one = 0; read(pipe_[0], &one, 1) == 1;) continue;
    fcntl(pipe_[0], F_SETFL, flags);
  }
  [[nodiscard]] std::chrono::milliseconds cpu_time() const {
    std::array<char, 512> text{};
    const std::string name = "/proc/" + std::to_string(pid_) + "/stat";
    std::FILE* file = std::fopen(name.c_str(), "r");
    EXPECT_NE(file, nullptr);
    (void)!std::fread(text.data(), 1, text.size() - 1, file);
    std::fclose(file);
    unsigned long user = 0;
    unsigned long system = 0;
    const char* behind_name = std::strrchr(text.data(), ')');
    EXPECT_EQ(
        std::sscanf(behind_name, ") %*c %*d %*d %*d %*d %*d %*u %*u %*u %*u %*u %lu %lu", &user, &system), 2);
    return std::chrono::milliseconds{(user + system) * 1000 /
                                     static_cast<unsigned long>(sysconf(_SC_CLK_TCK))};
  }

 private:
  [[noreturn]] void live(std::uint32_t domain, double lease_s) {
    close(pipe_[0]);
    sigset_t stop;
    sigemptyset(&stop);
    sigaddset(&stop, SIGTERM);
    sigprocmask(SIG_BLOCK, &stop, nullptr);
    {
      runtime::Bus bus{{.role = "robot_agent 1", .domain = domain, .lease_s = lease_s},
                       [this](const runtime::Discovery& news) {
                         if (news.kind == runtime::Discovery::Kind::kJoined) (void)!write(pipe_[1], "+", 1);
                         if (news.kind == runtime::Discovery::Kind::kGone) (void)!write(pipe_[1], "-", 1);
                       }};
      auto commands = bus.writer<msg::RobotCommandPubSubType>(idl::kCommand, 1);
      bus.reader<msg::RobotCommandPubSubType>(idl::kCommand, 1, [](const msg::RobotCommand&, const auto&) {});
      msg::RobotCommand command;
      commands.write(command);
      int number = 0;
      sigwait(&stop, &number);
    }
    _exit(0);
  }

  std::array<int, 2> pipe_{};
  pid_t pid_ = -1;
};

class LeftPeers : public ::testing::Test {
 protected:
  void expect_cheap(Peer& resident) const {
    EXPECT_LT(load_of(resident), kMostLoad);
    resident.forget_others();
    const Peer newcomer{domain_};
    resident.await_other();  // it is alive and reads its port
  }
  /// Processor time of the resident per wall time, over some seconds.
  [[nodiscard]] static double load_of(const Peer& resident) {
    constexpr auto kWatched = 4s;
    std::this_thread::sleep_for(500ms);  // the work that the peer's end causes is done by then
    const auto before = resident.cpu_time();
    std::this_thread::sleep_for(kWatched);
    const std::chrono::duration<double> used = resident.cpu_time() - before;
    const double load = used / kWatched;
    std::printf("load of the resident: %.1f %%\n", 100.0 * load);
    return load;
  }

  static constexpr double kMostLoad = 0.02;
  const runtime::DomainLock lock_{std::nullopt};
  runtime::SharedMemory leftovers_{lock_.domain()};
  const std::uint32_t domain_ = lock_.domain();
};

/// How a peer joins and leaves.
struct Way {
  const char* name;
  bool resident_is_suspended;  // while the peer leaves
  bool comes_meanwhile;
  int goes;  // the signal that ends it
};

class LeftPeersInEveryWay : public LeftPeers, public ::testing::WithParamInterface<Way> {};

TEST_P(LeftPeersInEveryWay, CostNothing) {
  const Way& way = GetParam();
  const double lease_s = way.resident_is_suspended ? 60.0 : 5.0;
  Peer resident{domain_, lease_s};
  Peer first{domain_, lease_s};
  resident.await_other();
  first.await_other();
  if (way.resident_is_suspended) resident.signal(SIGSTOP);
  std::optional<Peer> second;
  if (way.comes_meanwhile) {
    second.emplace(domain_, lease_s);
    first.await_other();
  }
  Peer& peer = second ? *second : first;
  leftovers_.note(peer.pid());
  if (way.goes == SIGSTOP) {
    peer.signal(SIGSTOP);
  } else {
    peer.kill(way.goes);
  }
  resident.signal(SIGCONT);
  expect_cheap(resident);
}

INSTANTIATE_TEST_SUITE_P(
    Way, LeftPeersInEveryWay,
    ::testing::Values(Way{"GoneCleanly", false, false, SIGTERM}, Way{"Killed", false, false, SIGKILL},
                      Way{"Suspended", false, false, SIGSTOP},
                      Way{"GoneWhileTheResidentIsSuspended", true, false, SIGTERM},
                      Way{"KilledWhileTheResidentIsSuspended", true, false, SIGKILL},
                      Way{"ComeAndGoneWhileTheResidentIsSuspended", true, true, SIGTERM},
                      Way{"ComeAndKilledWhileTheResidentIsSuspended", true, true, SIGKILL}),
    [](const auto& way) { return std::string{way.param.name}; });

// When the resident looks for peers, the place of this peer still exists, but its port does not.
TEST_F(LeftPeers, CostNothingWhenTheyGoInTheMomentInWhichTheResidentStarts) {
  auto place = std::make_unique<runtime::Place>(domain_);
  Peer resident{domain_};
  Peer other{domain_};
  resident.await_other();
  place.reset();
  expect_cheap(resident);
}

}  // namespace
}  // namespace caravan::test
