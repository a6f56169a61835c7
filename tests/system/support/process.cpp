// SPDX-License-Identifier: Apache-2.0
#include "tests/system/support/process.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <algorithm>
#include <fstream>
#include <iostream>

#include "runtime/bus/shared_memory_port.hpp"

namespace caravan::test {
namespace fs = std::filesystem;

std::optional<int> PatientProcess::wait(std::chrono::milliseconds patience) {
  std::optional<int> code;
  (void)eventually([&] { return (code = deploy::Process::wait({})).has_value(); }, patience);
  return code;
}

bool PatientProcess::prints(const std::string& text, std::chrono::milliseconds patience) const {
  // It prints nothing more once it has ended, whoever has waited for that.
  const auto has_ended = [this] {
    siginfo_t state{};
    return waitid(P_PID, static_cast<id_t>(pid()), &state, WEXITED | WNOHANG | WNOWAIT) != 0 ||
           state.si_pid != 0;
  };
  bool ended = false;
  bool found = false;
  (void)eventually(
      [&] {
        ended = has_ended();  // first: what it printed before its end counts
        found = deploy::Process::prints(text, {});
        return found || ended;
      },
      patience);
  return found;
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

std::string read_file(const fs::path& file) { return deploy::read_whole_file(file); }

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
    const std::string mark = runtime::shared_memory_mark() + "port";
    const std::size_t place = name.find(mark);
    if (place == std::string::npos) continue;
    const unsigned long port = std::strtoul(name.c_str() + place + mark.size(), nullptr, 10);
    if (runtime::is_port_of(static_cast<std::uint32_t>(port), domain)) names.push_back(name);
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

pid_t pid_in(std::uint32_t domain, const std::string& program, const std::string& more) {
  for (const pid_t pid : processes_in(domain)) {
    std::string line = read_file("/proc/" + std::to_string(pid) + "/cmdline");
    std::replace(line.begin(), line.end(), '\0', ' ');
    const bool is_program = line.substr(0, line.find(' ')).ends_with("/" + program);
    if (is_program && line.find(more) != std::string::npos) return pid;
  }
  return -1;
}

}  // namespace caravan::test
