// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <caravan/seen.hpp>
#include "deploy/kit/actions.hpp"
#include "deploy/kit/process.hpp"
#include "deploy/launcher/run_commands.hpp"
#include "runtime/host/shared_memory.hpp"

namespace caravan::deploy {

/// How the processes of a deployment are started.
struct ProcessSetup {
  RunSetup run;
  std::filesystem::path folder;  ///< for their logs
  std::uint32_t robots = 1;
  std::uint32_t agents_per_process = 1;  ///< number of robots that share a process
  std::string awaited;                   ///< observer without which the world does not begin
  std::map<std::string, std::vector<std::string>> arguments = {};  ///< additional ones, by process name
};

/// The processes of one deployment. They are addressed by their content: world, radio, robot 3.
///
/// A process has the same name, or `robots 1-4`; its log is robot_3.log or robots_1-4.log, after a restart
/// robot_3.2.log. The destructor kills those that still run and removes all their files in shared memory; the
/// deployment's own participant must be closed by then.
class Processes {
 public:
  /// @param on_end  called with the name of each process that an action has ended
  Processes(ProcessSetup setup, std::function<void(const std::string& name)> on_end);
  /// Executes the action, and waits for the processes that it ends.
  /// @return the error; empty on success
  std::string act(const ProcessAction& action);

  /// SIGTERM for all. Waits 2 s for their ends.
  void stop_all();

  /// The state of each process that was ever started, by the names of its content.
  [[nodiscard]] std::map<std::string, SeenProcess> seen() const;

  /// Notes the shared-memory files of running processes, in case they are killed later.
  void note_shared_memory();
  /// The same, only for processes that had no such files yet.
  void note_newcomers();

 private:
  using Kind = ProcessAction::Kind;
  struct Life {
    std::unique_ptr<Process> process;
    bool suspended = false;
    int lives = 0;
  };

  [[nodiscard]] std::string process_of(const std::string& name) const;
  [[nodiscard]] std::vector<std::string> processes_of(const std::vector<std::string>& names) const;
  [[nodiscard]] std::vector<std::string> command_line(const std::string& name) const;
  void start(const std::string& name);
  std::string end(const std::string& name, int number, std::chrono::milliseconds patience);
  std::string do_to(const std::string& name, Kind kind);
  [[nodiscard]] bool is_running(const std::string& name) const;

  ProcessSetup setup_;
  std::function<void(const std::string&)> on_end_;
  runtime::SharedMemory memory_;
  std::map<std::string, Life> lives_;
};

}  // namespace caravan::deploy
