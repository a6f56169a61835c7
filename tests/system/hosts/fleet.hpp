// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tests/system/support/process.hpp"

namespace caravan::test {

/// Where and how to start one of our programs.
using Starter = std::function<std::unique_ptr<PatientProcess>(std::vector<std::string> arguments,
                                                              const std::string& log)>;

/// The output of `caravan ctl status`.
struct FleetStatus {
  bool answered = false;
  std::string state;
  std::uint64_t steps = 0;
  std::uint32_t members = 0;
  bool disturbed = false;
  std::string gone;  ///< comma-separated; "-" if none
};

[[nodiscard]] FleetStatus read_status(const std::string& text);

/// The processes of one run, started by hand as in the field, and observed by `caravan ctl`. They are killed
/// at the end: when many leave at once, Fast DDS 2.9 sometimes aborts one (docs/faults.md).
class Fleet {
 public:
  /// @param options  of every program: --domain, --transport and so on
  Fleet(std::string scenario, std::vector<std::string> options)
      : scenario_{std::move(scenario)}, options_{std::move(options)} {}

  void start(const Starter& starter, const std::string& program, const std::string& robots = "");
  /// Kills with SIGKILL. @param robots as it was started with
  void kill(const std::string& program, const std::string& robots = "");
  [[nodiscard]] PatientProcess& process(const std::string& program, const std::string& robots = "");

  /// Asks until `wanted` holds, for `kPatience` at most. The end of the world's process ends the wait and
  /// fails the test with its log. @return the last answer
  FleetStatus watch(const Starter& starter, const std::function<bool(const FleetStatus&)>& wanted);
  /// The digest from the log of the world; empty if the run does not end within `patience`. The end of the
  /// world's process fails the test likewise.
  [[nodiscard]] std::string digest(std::chrono::milliseconds patience);
  /// Names and outputs of the processes that have ended.
  [[nodiscard]] std::vector<std::string> ended();

 private:
  /// False, and the test has failed: the world's process has ended.
  [[nodiscard]] bool has_world();

  std::string scenario_;
  std::vector<std::string> options_;
  std::map<std::string, std::unique_ptr<PatientProcess>> processes_;
};

inline bool is_whole(const FleetStatus& status, std::uint32_t robots) {
  return status.answered && status.members == robots && status.gone == "-";
}

}  // namespace caravan::test
