// SPDX-License-Identifier: Apache-2.0
#include "runtime/host/children.hpp"

#include <sys/wait.h>

#include <csignal>
#include <cstring>
#include <utility>

#include "runtime/host/spawn.hpp"

namespace caravan::runtime {

std::string how(const Ended& ended) {
  if (ended.exit_code <= 128)
    return "ended with exit code " + std::to_string(ended.exit_code) + ", its log says why";
  const int signal = ended.exit_code - 128;
  if (signal == SIGKILL) return "was killed by signal 9 (somebody did it, or the kernel for want of memory)";
  return "was ended by signal " + std::to_string(signal) + " (" + strsignal(signal) +
         "), its log may say why";
}

Children::Children(std::filesystem::path log_folder, std::function<void()> on_end, std::vector<int> shared)
    : log_folder_{std::move(log_folder)}, on_end_{std::move(on_end)}, shared_{std::move(shared)} {}

Children::~Children() {
  stop(std::chrono::seconds{3});
  {
    const std::lock_guard lock{mutex_};
    closing_ = true;
  }
  started_.notify_all();
  waiter_.join();
}

void Children::start(const std::string& name, const std::vector<std::string>& command_line) {
  {
    const std::lock_guard lock{mutex_};  // the waiting thread must not see its end before it has a name
    running_[spawn(command_line, log_folder_ / (name + ".log"), {.shared = shared_})] = name;
  }
  started_.notify_all();
}

void Children::watch() {
  if (waiter_.joinable()) return;
  waiter_ = std::thread{[this] { wait_for_ends(); }};
}

void Children::wait_for_ends() {
  for (;;) {
    {
      std::unique_lock lock{mutex_};
      started_.wait(lock, [this] { return closing_ || !running_.empty(); });
      if (running_.empty()) return;
    }
    int status = 0;
    const pid_t pid = waitpid(-1, &status, 0);
    if (pid < 0) continue;
    {
      const std::lock_guard lock{mutex_};
      const int code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
      ended_.push_back({running_[pid], pid, code});
      running_.erase(pid);
    }
    none_left_.notify_all();
    on_end_();
  }
}

std::vector<Ended> Children::ended() {
  const std::lock_guard lock{mutex_};
  return std::exchange(ended_, {});
}

std::vector<pid_t> Children::running() const {
  const std::lock_guard lock{mutex_};
  std::vector<pid_t> pids;
  for (const auto& [pid, name] : running_) pids.push_back(pid);
  return pids;
}

void Children::signal_all(int signal) const {
  const std::lock_guard lock{mutex_};
  for (const auto& [pid, name] : running_) kill(pid, signal);
}

bool Children::wait_until_none(std::chrono::milliseconds patience) {
  std::unique_lock lock{mutex_};
  return none_left_.wait_for(lock, patience, [this] { return running_.empty(); });
}

std::vector<std::string> Children::stop(std::chrono::milliseconds patience) {
  watch();
  std::vector<std::string> killed;
  signal_all(SIGTERM);
  signal_all(SIGCONT);  // a stopped process cannot act on SIGTERM
  if (wait_until_none(patience)) return killed;
  {
    const std::lock_guard lock{mutex_};
    for (const auto& [pid, name] : running_) killed.push_back(name);
  }
  signal_all(SIGKILL);
  wait_until_none(std::chrono::seconds{2});
  return killed;
}

}  // namespace caravan::runtime
