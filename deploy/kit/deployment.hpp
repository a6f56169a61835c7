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
  std::string changes = {};                  ///< TOML that is laid over it: `experiment.items = 10`
  std::filesystem::path folder = {};         ///< exists; the effective scenario and the logs go there
  std::filesystem::path binaries = {};       ///< of world_server etc.; empty: beside this program, or ../bin
  std::optional<std::uint32_t> domain = {};  ///< none: a free one
  runtime::Transport transport = runtime::Transport::kSharedMemory;  ///< of every process, and of the kit
  double lease_s = 2.0;                  ///< of every process: silent for so long, it counts as gone
  std::uint32_t agents_per_process = 1;  ///< robots that share a process live and die together
  bool hold_start = false;               ///< the world begins only after the action `go`
  std::map<std::string, std::vector<std::string>> arguments = {};  ///< further ones, by process name
  std::function<bool()> is_interrupted = {};                       ///< ends every wait
};

/// What an action or an expectation led to.
struct ActionResult {
  bool good = false;
  std::string text;     ///< why not: what was waited for, and what was seen
  double took_s = 0.0;  ///< wall time
};

/// World server, radio emulator and agents as real processes in a private DDS domain, under the hands of a
/// test: start, kill, suspend, cut off, hold, teleport, and wait for what is expected to come of it.
///
/// Nothing runs before the first action `start`. Every wait has a deadline and says what it waited for. The
/// end stops all processes and removes what they left in shared memory.
class Deployment {
 public:
  /// @throws runtime::StartError when the scenario cannot be read or no domain is free
  explicit Deployment(DeploymentOptions options);
  ~Deployment();
  Deployment(const Deployment&) = delete;
  Deployment& operator=(const Deployment&) = delete;

  /// Does one action of the table, as in `kill robot 2` or `teleport 3 1.0 -2.0`.
  /// @throws WordsError when it is written wrong
  ActionResult act(const std::string& line);
  /// Waits until `condition` holds.
  /// @param name  what it means to the reader, for messages
  ActionResult expect(const std::string& name, const Condition& condition, std::chrono::milliseconds within);

  /// Lets a paused world take single steps until `condition` holds, `most` at most, and leaves it paused.
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
  runtime::DomainLock lock_;  // before the first file: who finds the domain taken leaves nothing behind
  std::filesystem::path scenario_file_;
  std::uint32_t robots_ = 0;
  Processes processes_;
  std::unique_ptr<RunListener> listener_;
  std::chrono::steady_clock::time_point noted_{};
};

}  // namespace caravan::deploy
