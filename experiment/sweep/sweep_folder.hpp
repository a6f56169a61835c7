// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "experiment/sweep/plan.hpp"
#include "runtime/process/loop.hpp"

namespace caravan::experiment {

/// The kind of work on a sweep's folder. Any number of tasks may work at the same time; a whole sweep only
/// alone.
enum class Claim : std::uint8_t {
  kSweep,     ///< executes runs and writes the tables
  kTask,      ///< executes one run and writes nothing outside its folder
  kSummarise  ///< writes the tables and executes no run
};

/// The folder of a sweep, created if it is new. It is locked against other sweeps, and against a second start
/// of the same task, until this object and every process that shares its locks are gone: a process started by
/// an earlier sweep may outlive it for a moment.
class SweepFolder {
 public:
  /// @param task  with Claim::kTask: the run's index in the plan
  /// @throws runtime::StartError when the folder cannot be written, when another process is working in it, or
  ///         when its content does not belong to this sweep: the same scenario with the same options and
  ///         controllers, and no run that is not in the plan. Runs may be added.
  SweepFolder(std::filesystem::path folder, const SweepPlan& plan, Claim claim, runtime::Loop& loop,
              std::size_t task = 0);

  /// Descriptors of the locks, shared with the runs.
  [[nodiscard]] std::vector<int> locks() const;

  /// The effective scenario of the sweep, from which every run starts.
  [[nodiscard]] std::filesystem::path scenario_file() const { return folder_ / "scenario.toml"; }

 private:
  /// An open lock file.
  class Lock {
   public:
    /// @param holder  the possible holder, for the message
    Lock(const std::filesystem::path& file, int kind, const std::string& holder, runtime::Loop& loop);
    ~Lock();
    Lock(Lock&& other) noexcept : file_{std::exchange(other.file_, -1)} {}
    Lock& operator=(Lock&&) = delete;
    [[nodiscard]] int descriptor() const { return file_; }

   private:
    int file_ = -1;
  };

  std::filesystem::path folder_;
  std::vector<Lock> locks_;
};

}  // namespace caravan::experiment
