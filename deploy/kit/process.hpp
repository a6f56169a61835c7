// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace caravan::deploy {

/// One program, started as by a user; killed when this object is destroyed.
class Process {
 public:
  /// @param command_line  the first word is the program's path
  /// @param log           receives its output and errors
  /// @throws runtime::StartError when it cannot be started
  Process(std::vector<std::string> command_line, std::filesystem::path log);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  [[nodiscard]] pid_t pid() const { return pid_; }
  /// The exit code (128 + n for signal n), none if it still runs after `patience`.
  std::optional<int> wait(std::chrono::milliseconds patience);
  void signal(int number) const;
  /// Its output so far.
  [[nodiscard]] std::string output() const;
  /// Whether `text` appears in its output within `patience`.
  [[nodiscard]] bool prints(const std::string& text, std::chrono::milliseconds patience) const;
  /// Processor time used so far.
  [[nodiscard]] std::chrono::milliseconds cpu_time() const;
  [[nodiscard]] const std::filesystem::path& log() const { return log_; }

 private:
  pid_t pid_ = -1;
  std::filesystem::path log_;
  std::optional<int> exit_code_;
};

/// Private memory of a process and the shared pages it has touched, MB. None: it has ended.
[[nodiscard]] std::optional<double> memory_mb(pid_t process);
/// Number of its open file descriptors.
[[nodiscard]] std::optional<std::size_t> descriptors(pid_t process);

/// The whole file as text; empty when there is none.
[[nodiscard]] std::string read_whole_file(const std::filesystem::path& file);

}  // namespace caravan::deploy
