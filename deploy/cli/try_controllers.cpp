// SPDX-License-Identifier: Apache-2.0
#include "deploy/cli/try_controllers.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstring>

#include "robot_agent/config/agent_config.hpp"
#include "robot_agent/controller/controllers.hpp"
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

/// Until the other end is closed or time is up. @return false: time is up
bool read_all(int file, std::string& text) {
  const Clock::time_point end = Clock::now() + kPatience;
  std::array<char, 4096> part{};
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    if (left <= 0) return false;
    pollfd one{.fd = file, .events = POLLIN, .revents = 0};
    if (poll(&one, 1, static_cast<int>(left)) <= 0) continue;
    const ssize_t size = read(file, part.data(), part.size());
    if (size <= 0) return true;
    text.append(part.data(), static_cast<std::size_t>(size));
  }
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
    const std::string text = verdict(scenario, controller);
    (void)!write(ends[1], text.data(), text.size());
    _exit(0);
  }
  close(ends[1]);
  std::string text;
  const bool in_time = read_all(ends[0], text);
  close(ends[0]);
  if (!in_time) kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  if (!in_time) {
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
