// SPDX-License-Identifier: Apache-2.0
#include "deploy/kit/process.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>
#include <utility>

#include "runtime/host/spawn.hpp"

namespace caravan::deploy {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kLookPeriod{5};

template <typename Condition>
bool eventually(Condition condition, std::chrono::milliseconds patience) {
  const auto deadline = Clock::now() + patience;
  while (!condition()) {
    if (Clock::now() >= deadline) return condition();
    std::this_thread::sleep_for(kLookPeriod);
  }
  return true;
}

}  // namespace

Process::Process(std::vector<std::string> command_line, std::filesystem::path log)
    // A parent that crashes leaves no process behind.
    : pid_{runtime::spawn(std::move(command_line), log, {.when_parent_dies = SIGKILL})},
      log_{std::move(log)} {}

Process::~Process() {
  if (exit_code_) return;
  kill(pid_, SIGKILL);
  (void)wait(std::chrono::seconds{5});
}

std::optional<int> Process::wait(std::chrono::milliseconds patience) {
  (void)eventually(
      [this] {
        int status = 0;
        if (!exit_code_ && waitpid(pid_, &status, WNOHANG) == pid_) {
          exit_code_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
        }
        return exit_code_.has_value();
      },
      patience);
  return exit_code_;
}

void Process::signal(int number) const {
  if (!exit_code_) kill(pid_, number);
}

std::string Process::output() const { return read_whole_file(log_); }

bool Process::prints(const std::string& text, std::chrono::milliseconds patience) const {
  return eventually([&] { return output().find(text) != std::string::npos; }, patience);
}

std::chrono::milliseconds Process::cpu_time() const {
  std::string stat = read_whole_file("/proc/" + std::to_string(pid_) + "/stat");
  std::istringstream fields{stat.substr(stat.rfind(')') + 2)};
  std::string skipped;
  for (int i = 0; i < 11; ++i) fields >> skipped;
  long user = 0;
  long system = 0;
  fields >> user >> system;
  return std::chrono::milliseconds{(user + system) * 1000 / sysconf(_SC_CLK_TCK)};
}

std::optional<double> memory_mb(pid_t process) {
  std::ifstream status{"/proc/" + std::to_string(process) + "/status"};
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1024.0;
  }
  return std::nullopt;
}

std::optional<std::size_t> descriptors(pid_t process) {
  std::error_code error;
  const std::filesystem::directory_iterator entries{"/proc/" + std::to_string(process) + "/fd", error};
  if (error) return std::nullopt;
  return static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
}

std::string read_whole_file(const std::filesystem::path& file) {
  std::ifstream in{file};
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace caravan::deploy
