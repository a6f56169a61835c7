// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "deploy/kit/actions.hpp"
#include "deploy/kit/condition.hpp"
#include "deploy/kit/processes.hpp"
#include "deploy/kit/run_listener.hpp"
#include "deploy/kit/seen.hpp"
#include "runtime/bus/transport.hpp"
#include "runtime/host/domain_lock.hpp"

namespace caravan::deploy {

struct DeploymentOptions {
  std::filesystem::path scenario;            ///< TOML file
  std::string changes = {};                  ///< TOML that overrides it: `experiment.items = 10`
  std::string controller = {};               ///< replaces `controller.library`; an absolute path
  std::filesystem::path folder = {};         ///< exists; receives the effective scenario and the logs
  std::filesystem::path binaries = {};       ///< of world_server etc.; empty: beside this program, or ../bin
  std::filesystem::path agent = {};          ///< program in the place of robot_agent; empty: none
  std::optional<std::uint32_t> domain = {};  ///< none: a free one
  runtime::Transport transport = runtime::Transport::kSharedMemory;  ///< of every process, and of the kit
  double lease_s = 2.0;                  ///< of every process: silent for this long, it counts as gone
  std::uint32_t agents_per_process = 1;  ///< number of robots that share a process
  bool hold_start = false;               ///< the world begins only after the action `go`
  std::map<std::string, std::vector<std::string>> arguments = {};  ///< additional ones, by process name
  std::function<bool()> is_interrupted = {};                       ///< ends every wait
};

/// The result of an action or an expectation.
struct ActionResult {
  bool good = false;
  std::string text;     ///< on failure: the expected and the observed state
  double took_s = 0.0;  ///< wall time
};

/// World server, radio emulator and agents as real processes in a private DDS domain, controlled by a test:
/// start, kill, suspend, disconnect, hold, teleport, and wait for the expected outcome.
///
/// Nothing runs before the first action `start`. Every wait has a deadline and names its condition. The
/// destructor stops all processes and removes their files in shared memory.
class Deployment {
 public:
  /// @throws runtime::StartError when the scenario cannot be read or no domain is free
  explicit Deployment(DeploymentOptions options);
  ~Deployment();
  Deployment(const Deployment&) = delete;
  Deployment& operator=(const Deployment&) = delete;

  /// Executes one action of the table, such as `kill robot 2` or `teleport 3 1.0 -2.0`.
  /// @throws WordsError on a syntax error
  ActionResult act(const std::string& line);
  /// Waits until `condition` holds.
  /// @param name  description for messages
  ActionResult expect(const std::string& name, const Condition& condition, std::chrono::milliseconds within);

  /// Single-steps a paused world until `condition` holds, at most `most` steps, and leaves it paused.
  ActionResult step_until(const Condition& condition, std::uint64_t most);

  [[nodiscard]] Seen seen();
  [[nodiscard]] std::uint32_t domain() const { return lock_.domain(); }
  [[nodiscard]] std::uint32_t robots() const { return robots_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return options_.folder; }

 private:
  ActionResult ask(const caravan_interfaces::msg::ControlRequest& request);
  ActionResult hold_at(std::uint64_t step);
  [[nodiscard]] std::string scene(const Seen& seen) const;

  DeploymentOptions options_;
  runtime::DomainLock lock_;  // before the first file: if the domain is taken, nothing is left behind
  std::filesystem::path scenario_file_;
  std::uint32_t robots_ = 0;
  Processes processes_;
  std::unique_ptr<RunListener> listener_;
  std::chrono::steady_clock::time_point noted_{};
};

}  // namespace caravan::deploy
