// SPDX-License-Identifier: Apache-2.0
#include "runtime/host/children.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include "runtime/config/start_error.hpp"

namespace caravan::runtime {
namespace {

/// In the child between fork and exec: nothing but system calls.
[[noreturn]] void become(const std::vector<char*>& arguments, int log, pid_t parent,
                         const std::vector<int>& shared) {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  signal(SIGPIPE, SIG_DFL);
  // A group of its own: Ctrl-C at the terminal goes to the launcher alone, which stops everybody in order.
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(1);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  unsigned first = STDERR_FILENO + 1;  // this process's DDS sockets are not the child's
  for (const int kept : shared) {
    if (static_cast<unsigned>(kept) > first) close_range(first, static_cast<unsigned>(kept) - 1, 0);
    first = static_cast<unsigned>(kept) + 1;
  }
  close_range(first, ~0U, 0);
  execv(arguments[0], arguments.data());
  _exit(127);
}

}  // namespace

Children::Children(std::filesystem::path log_folder, std::function<void()> on_end, std::vector<int> shared)
    : log_folder_{std::move(log_folder)}, on_end_{std::move(on_end)}, shared_{std::move(shared)} {
  std::sort(shared_.begin(), shared_.end());
}

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
  const std::string log_file = log_folder_ / (name + ".log");
  const int log = open(log_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (log < 0) throw StartError{log_file + ": " + std::strerror(errno)};
  std::vector<std::string> words = command_line;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t parent = getpid();
  {
    const std::lock_guard lock{mutex_};  // the waiter must not see its end before it has a name
    const pid_t pid = fork();
    if (pid == 0) become(arguments, log, parent, shared_);
    close(log);
    if (pid < 0) throw StartError{"cannot start " + name + ": " + std::strerror(errno)};
    running_[pid] = name;
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
