// SPDX-License-Identifier: Apache-2.0
#include "tests/system/support/process.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <thread>

namespace caravan::test {
namespace fs = std::filesystem;

bool pause_until_next_look(std::chrono::steady_clock::time_point deadline) {
  if (std::chrono::steady_clock::now() >= deadline) return false;
  std::this_thread::sleep_for(std::chrono::milliseconds{5});
  return true;
}

Process::Process(std::vector<std::string> arguments, fs::path log) : log_{std::move(log)} {
  arguments[0] = std::string{CARAVAN_BIN_DIR} + "/" + arguments[0];
  std::vector<char*> words;
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  const int file = open(log_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  pid_ = fork();
  if (pid_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // a test that crashes leaves no process behind
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    execv(words[0], words.data());
    _exit(127);
  }
  close(file);
}

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

std::string Process::output() const { return read_file(log_); }

bool Process::prints(const std::string& text, std::chrono::milliseconds patience) const {
  return eventually([&] { return output().find(text) != std::string::npos; }, patience);
}

std::chrono::milliseconds Process::cpu_time() const {
  std::string stat = read_file("/proc/" + std::to_string(pid_) + "/stat");
  std::istringstream fields{stat.substr(stat.rfind(')') + 2)};
  std::string skipped;
  for (int i = 0; i < 11; ++i) fields >> skipped;
  long user = 0;
  long system = 0;
  fields >> user >> system;
  return std::chrono::milliseconds{(user + system) * 1000 / sysconf(_SC_CLK_TCK)};
}

ScratchFolder::ScratchFolder() {
  std::string pattern = fs::temp_directory_path() / "caravan_test_XXXXXX";
  path_ = mkdtemp(pattern.data());
}

ScratchFolder::~ScratchFolder() {
  if (testing::Test::HasFailure()) {
    std::cout << "logs kept in " << path_ << "\n";
    return;
  }
  std::error_code error;
  fs::remove_all(path_, error);
}

std::string read_file(const fs::path& file) {
  std::ifstream in{file};
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

void write_file(const fs::path& file, const std::string& text) { std::ofstream{file} << text; }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << "no \"" << from << "\" to replace";
  return place == std::string::npos ? text : text.replace(place, from.size(), to);
}

std::vector<std::string> left_in_shared_memory(std::uint32_t domain) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator{"/dev/shm"}) {
    const std::string name = entry.path().filename();
    const std::size_t place = name.find("fastrtps_port");
    if (place == std::string::npos) continue;
    const unsigned long port = std::strtoul(name.c_str() + place + 13, nullptr, 10);
    if (port / 250 == (7400UL + 250UL * domain) / 250) names.push_back(name);
  }
  return names;
}

std::vector<pid_t> processes_in(std::uint32_t domain) {
  std::vector<pid_t> pids;
  const std::string wanted = std::string{"--domain"} + '\0' + std::to_string(domain) + '\0';
  for (const auto& entry : fs::directory_iterator{"/proc"}) {
    const pid_t pid = static_cast<pid_t>(std::strtol(entry.path().filename().c_str(), nullptr, 10));
    if (pid > 0 && read_file(entry.path() / "cmdline").find(wanted) != std::string::npos) pids.push_back(pid);
  }
  return pids;
}

fs::path scenario(const std::string& name) {
  return fs::path{CARAVAN_SOURCE_DIR} / "deploy" / "scenarios" / name;
}

}  // namespace caravan::test
