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

#include <caravan/condition.hpp>
#include <caravan/seen.hpp>

namespace caravan::deploy {

struct DeploymentOptions {
  std::filesystem::path scenario;            ///< TOML file
  std::string changes = {};                  ///< TOML that overrides it: `experiment.items = 10`
  std::string controller = {};               ///< replaces `controller.library`; an absolute path
  std::filesystem::path folder = {};         ///< exists; receives the effective scenario and the logs
  std::filesystem::path binaries = {};       ///< of world_server etc.; empty: those installed with the kit
  std::filesystem::path agent = {};          ///< program in the place of robot_agent; empty: none
  std::optional<std::uint32_t> domain = {};  ///< none: a free one
  std::string transport = "shm";  ///< of every process, and of the kit: shm, udp, or a profile FILE.xml
  double lease_s = 2.0;           ///< of every process: silent for this long, it counts as gone
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
///
/// The exceptions that it throws are derived from std::exception; their text is one line.
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
  [[nodiscard]] std::uint32_t domain() const;
  [[nodiscard]] std::uint32_t robots() const;
  [[nodiscard]] const std::filesystem::path& folder() const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace caravan::deploy
