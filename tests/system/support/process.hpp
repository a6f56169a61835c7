// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "deploy/kit/process.hpp"
#include "tests/support/patience.hpp"

namespace caravan::test {

/// Like that of the kit, but waits longer on a busy machine.
class PatientProcess : public deploy::Process {
 public:
  using deploy::Process::Process;
  std::optional<int> wait(std::chrono::milliseconds patience);
  [[nodiscard]] bool prints(const std::string& text, std::chrono::milliseconds patience) const;
  /// Whether it still runs after this wall time.
  [[nodiscard]] bool runs_on_for(std::chrono::milliseconds time) { return !deploy::Process::wait(time); }
};

/// One of our programs, started as by a user. Stopped with SIGTERM when this object is destroyed, so that it
/// leaves nothing behind; killed if it does not stop.
class Process : public PatientProcess {
 public:
  /// @param arguments  the first is the program's name in the folder of binaries
  /// @param log        receives its output and errors
  Process(std::vector<std::string> arguments, std::filesystem::path log);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
};

/// A folder for one test: removed if the test passed; kept, and its path printed, if it failed.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

[[nodiscard]] std::string read_file(const std::filesystem::path& file);
void write_file(const std::filesystem::path& file, const std::string& text);
/// `text` with the first `from` replaced. Fails the test if there is none.
[[nodiscard]] std::string replaced(std::string text, const std::string& from, const std::string& to);
/// DDS files in /dev/shm that belong to the domain's ports or to no running process.
[[nodiscard]] std::vector<std::string> left_in_shared_memory(std::uint32_t domain);
/// Pids of running processes whose command line has `--domain <domain>`.
[[nodiscard]] std::vector<pid_t> processes_in(std::uint32_t domain);
/// The pid of the one that runs this program and has `more` in its command line; -1 if there is none.
[[nodiscard]] pid_t pid_in(std::uint32_t domain, const std::string& program, const std::string& more = "");
[[nodiscard]] std::filesystem::path scenario(const std::string& name);

}  // namespace caravan::test
