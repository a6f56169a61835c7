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

#include "robot_agent/config/agent_config.hpp"
#include "robot_agent/controller/controllers.hpp"
#include "runtime/controller/call_watch.hpp"
#include "runtime/scenario/shared_tables.hpp"

namespace caravan::deploy {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kPatience{10};
constexpr char kGood = '+';
constexpr char kRefused = '-';

std::string make_all(const runtime::TomlDocument& scenario, const std::string& controller) {
  const agent::Controllers controllers{scenario, controller};
  agent::Config config = agent::load_config(scenario, 1);
  for (std::uint32_t robot = 1; robot <= runtime::read_robots(scenario).count; ++robot) {
    config.id.value = static_cast<std::uint16_t>(robot);
    (void)controllers.make(config);
  }
  return controllers.name();
}

/// In the process of its own: kGood and the name, or kRefused and why.
std::string verdict(const runtime::TomlDocument& scenario, const std::string& controller) {
  try {
    return kGood + make_all(scenario, controller);
  } catch (const runtime::StartError& error) {
    return kRefused + std::string{error.what()};
  }
}

enum class Read : std::uint8_t { kAll, kTimeIsUp, kStop };

/// Until the other end is closed, time is up, or the process is told to stop.
Read read_all(int file, std::string& text) {
  constexpr std::chrono::milliseconds kTick{100};  // bounds the delay in noticing a signal
  const Clock::time_point end = Clock::now() + kPatience;
  std::array<char, 4096> part{};
  while (Clock::now() < end) {
    if (runtime::stop_is_pending()) return Read::kStop;
    pollfd one{.fd = file, .events = POLLIN, .revents = 0};
    if (poll(&one, 1, static_cast<int>(kTick.count())) <= 0) continue;
    const ssize_t size = read(file, part.data(), part.size());
    if (size <= 0) return Read::kAll;
    text.append(part.data(), static_cast<std::size_t>(size));
  }
  return Read::kTimeIsUp;
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
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const std::string text = verdict(scenario, controller);
    (void)!write(ends[1], text.data(), text.size());
    _exit(0);
  }
  close(ends[1]);
  std::string text;
  const Read how = read_all(ends[0], text);
  close(ends[0]);
  if (how != Read::kAll) kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  if (how == Read::kStop) throw Interrupted{};
  if (how == Read::kTimeIsUp) {
    throw runtime::StartError{"controller " + controller + ": is not made within " +
                              std::to_string(kPatience.count()) + " s: a constructor does not return"};
  }
  if (text.empty()) {
    throw runtime::StartError{"controller " + controller + ": ended the process that made it, by " +
                              how_it_ended(status)};
  }
  if (text.front() == kRefused) throw runtime::StartError{text.substr(1)};
  return text.substr(1);
}

}  // namespace caravan::deploy
