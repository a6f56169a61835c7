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

#include "deploy/kit/actions.hpp"
#include "deploy/kit/process.hpp"
#include "deploy/kit/seen.hpp"
#include "deploy/launcher/run_commands.hpp"
#include "runtime/host/shared_memory.hpp"

namespace caravan::deploy {

/// How the processes of a deployment are started.
struct ProcessSetup {
  RunSetup run;
  std::filesystem::path folder;  ///< of their logs
  std::uint32_t robots = 1;
  std::uint32_t agents_per_process = 1;  ///< robots that share a process live and die together
  std::string awaited;                   ///< observer without whom the world does not begin
  std::map<std::string, std::vector<std::string>> arguments = {};  ///< further ones, by process name
};

/// The processes of one deployment. They are addressed by who lives in them: world, radio, robot 3.
///
/// A process is called so too, or `robots 1-4`, and its log robot_3.log or robots_1-4.log; its second life
/// writes robot_3.2.log. The end kills those that still run and removes what all of them left in shared
/// memory; the deployment's own participant must be closed by then.
class Processes {
 public:
  /// @param on_end  told the name of each that an action has ended
  Processes(ProcessSetup setup, std::function<void(const std::string& name)> on_end);
  /// Does it, waiting for the ends of those that are to end.
  /// @return what went wrong; empty: nothing
  std::string act(const ProcessAction& action);

  /// SIGTERM for all. Waits 2 s for their ends.
  void stop_all();

  /// The state of each that was ever started, by the names of those who live there.
  [[nodiscard]] std::map<std::string, SeenProcess> seen() const;

  /// Remembers what the living have in shared memory, for those that are killed later.
  void note_shared_memory();
  /// The same of those that had nothing there yet.
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
