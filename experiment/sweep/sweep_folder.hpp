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

/// Who works on a sweep's folder. Any number of tasks may do so at the same time; a whole sweep only alone.
enum class Claim : std::uint8_t {
  kSweep,     ///< does runs and writes the tables
  kTask,      ///< does one run and writes nothing outside its folder
  kSummarise  ///< writes the tables and does no run
};

/// The folder of a sweep, made when it is new, and held against other sweeps, and against a second start of
/// the same task, until this object and every process that has its locks are gone: what an earlier sweep
/// started may outlive it for a moment.
class SweepFolder {
 public:
  /// @param task  with Claim::kTask: the run's index in the plan
  /// @throws runtime::StartError when the folder cannot be written, when somebody else is at work in it, or
  ///         when it holds something else than a part of this sweep: the same scenario with the same
  ///         options, and no run that is not in the plan. Runs may be added.
  SweepFolder(std::filesystem::path folder, const SweepPlan& plan, Claim claim, runtime::Loop& loop,
              std::size_t task = 0);

  /// Descriptors of the locks, for the runs to share.
  [[nodiscard]] std::vector<int> locks() const;

  /// The effective scenario of the sweep in it, from which every run starts.
  [[nodiscard]] std::filesystem::path scenario_file() const { return folder_ / "scenario.toml"; }

 private:
  /// An open lock file.
  class Lock {
   public:
    /// @param holder  whoever may hold it, for the message
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
