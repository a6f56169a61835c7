// SPDX-License-Identifier: Apache-2.0
#include "deploy/cli/try_controllers.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstring>
#include <memory>
#include <string_view>

#include "robot_agent/config/agent_config.hpp"
#include "robot_agent/controller/controllers.hpp"
#include "runtime/controller/call_watch.hpp"
#include "runtime/pure/one_line.hpp"
#include "runtime/scenario/shared_tables.hpp"

namespace caravan::deploy {
namespace {

using Clock = std::chrono::steady_clock;

// What the process of its own tells: records of one of these kinds, a text, and kEnd.
constexpr char kCall = '~';     ///< what is called from now on
constexpr char kGood = '+';     ///< the last one: the controller's name
constexpr char kRefused = '-';  ///< the last one: why
constexpr char kEnd = '\0';

/// In the process of its own.
class Teller {
 public:
  explicit Teller(int file) : file_{file} {}
  /// A process that the controller has forked has nothing to tell, and ends.
  void tell(char kind, const std::string& text) const {
    if (getpid() != told_by_) _exit(0);
    const std::string record = kind + std::string{text.c_str()} + kEnd;
    (void)!write(file_, record.data(), record.size());
  }

 private:
  int file_;
  pid_t told_by_ = getpid();
};

std::string make_all(const runtime::TomlDocument& scenario, const std::string& controller,
                     const Teller& teller) {
  const agent::Controllers controllers{scenario, controller};
  agent::Config config = agent::load_config(scenario, 1);
  for (std::uint32_t robot = 1; robot <= runtime::read_robots(scenario).count; ++robot) {
    config.id.value = static_cast<std::uint16_t>(robot);
    const std::string who =
        "controller " + pure::one_line(controllers.name()) + ", robot " + std::to_string(robot) + ": ";
    teller.tell(kCall, who + "its constructor");
    std::unique_ptr<Controller> made = controllers.make(config);
    teller.tell(kCall, who + "its destructor");
    made.reset();
  }
  return controllers.name();
}

[[noreturn]] void be_the_process(const runtime::TomlDocument& scenario, const std::string& controller,
                                 int file) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const Teller teller{file};
  try {
    teller.tell(kGood, make_all(scenario, controller, teller));
  } catch (const std::exception& error) {
    teller.tell(kRefused, error.what());
  }
  _exit(0);
}

/// What has been read of the records.
struct Told {
  std::string called;
  std::string verdict;  ///< the first of the last records, with its kind; empty: none yet
  std::string rest;     ///< the beginning of a record

  /// @return whether there was a whole record
  bool take(std::string_view text) {
    rest += text;
    bool is_news = false;
    for (std::size_t end = 0; verdict.empty() && (end = rest.find(kEnd)) != std::string::npos;) {
      is_news = true;
      if (rest.front() == kCall)
        called = rest.substr(1, end - 1);
      else
        verdict = rest.substr(0, end);
      rest.erase(0, end + 1);
    }
    return is_news;
  }
};

/// Also when the system keeps no ends of children, because this process was started with SIGCHLD ignored.
bool has_ended(pid_t child) {
  siginfo_t info{};
  return waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid != 0;
}

enum class Read : std::uint8_t { kAll, kTimeIsUp, kStop };

/// Until the verdict or the end of the child, time is up for one call, or this process is told to stop. The
/// end of the file alone says nothing: the controller may close it, or a process that it has forked keep it.
Read read_all(int file, pid_t child, Told& told) {
  constexpr std::chrono::milliseconds kTick{100};  // bounds the delay in noticing a signal
  Clock::time_point end = Clock::now() + runtime::CallWatch::kLongestCall;
  std::array<char, 4096> part{};
  while (told.verdict.empty()) {
    if (runtime::stop_is_pending()) return Read::kStop;
    if (Clock::now() >= end) return Read::kTimeIsUp;
    const bool ended = has_ended(child);
    pollfd one{.fd = file, .events = POLLIN, .revents = 0};
    const bool has_more = poll(&one, 1, ended ? 0 : static_cast<int>(kTick.count())) > 0;
    const ssize_t size = has_more ? read(file, part.data(), part.size()) : 0;
    if (size <= 0 && ended) return Read::kAll;
    if (size <= 0 && has_more) file = -1;  // poll() only waits from now on
    if (size > 0 && told.take({part.data(), static_cast<std::size_t>(size)}))
      end = Clock::now() + runtime::CallWatch::kLongestCall;
  }
  return Read::kAll;
}

std::string how_it_ended(int status) {
  if (!WIFSIGNALED(status)) return "exit code " + std::to_string(WEXITSTATUS(status));
  return "signal " + std::to_string(WTERMSIG(status)) + " (" + strsignal(WTERMSIG(status)) + ")";
}

}  // namespace

std::string try_controllers(const runtime::TomlDocument& scenario, const std::string& controller) {
  // The paper's agent is no library, and its tables are checked already.
  if (controller == agent::kPaper) return agent::Controllers{scenario, controller}.name();
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    throw runtime::StartError{std::string{"pipe: "} + std::strerror(errno)};
  const pid_t child = fork();
  if (child < 0) throw runtime::StartError{std::string{"fork: "} + std::strerror(errno)};
  if (child == 0) be_the_process(scenario, controller, ends[1]);
  close(ends[1]);
  Told told{.called = "controller " + controller + ": its loading", .verdict = {}, .rest = {}};
  const Read how = read_all(ends[0], child, told);
  if (how != Read::kAll) kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  close(ends[0]);
  if (how == Read::kStop) throw Interrupted{};
  if (how == Read::kTimeIsUp) {
    throw runtime::StartError{told.called + " " + to_text(runtime::CallWatch::Reason::kTooLong)};
  }
  if (told.verdict.empty())
    throw runtime::StartError{told.called + " ended the process that made it, by " + how_it_ended(status)};
  if (told.verdict.front() == kRefused) throw runtime::StartError{told.verdict.substr(1)};
  return told.verdict.substr(1);
}

}  // namespace caravan::deploy
