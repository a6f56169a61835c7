// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "experiment/metrics/metrics_json.hpp"
#include "experiment/sweep/plan.hpp"

/// The folder of a sweep and the files of its runs, without running anything.
namespace caravan::experiment {

/// A folder that is removed at the end of the test.
class Folder {
 public:
  Folder() {
    std::string pattern = std::filesystem::temp_directory_path() / "caravan_sweep_XXXXXX";
    path_ = mkdtemp(pattern.data());
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline void write(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream{file} << text;
}

/// metrics.json of a run of two robots, one with a path of 10 m.
inline std::string metrics_text(double sim_time_s, bool ended = true, const RunEnd& end = {}) {
  const RunFacts facts{.scenario = "course", .engine = "embedded", .mode = "full", .robots = 2, .items = 1};
  Result result;
  result.sim_time = std::chrono::duration_cast<Time>(std::chrono::duration<double>{sim_time_s});
  result.items_delivered = 1;
  result.routes = 1;
  result.robots = {
      {.id = 1, .found = Time{1}, .received = {}, .items = 1, .path_length_m = 10.0, .times = {}},
      {.id = 2, .found = {}, .received = {}, .items = 0, .path_length_m = {}, .times = {}}};
  RunEnd with_digest = end;
  with_digest.digest = "0123456789abcdef";
  return metrics_json(facts, result, with_digest, ended);
}

inline SweepPlan plan_of(const std::vector<std::string>& modes, const std::vector<std::uint64_t>& seeds) {
  SweepPlan plan{.scenario = "course",
                 .scenario_text = "name = \"course\"\n",
                 .engine = "embedded",
                 .modes = modes,
                 .seeds = seeds,
                 .runs = {}};
  for (const std::string& mode : modes) {
    for (const std::uint64_t seed : seeds) {
      plan.runs.push_back({mode, seed, "# " + mode + " " + std::to_string(seed) + "\n"});
    }
  }
  return plan;
}

/// The plan at the points radio.range_m = 2 and 4 of a sweep with this axis.
inline SweepPlan with_axis(const SweepPlan& plan) {
  SweepPlan grid = plan;
  grid.axes = {"radio.range_m"};
  grid.runs.clear();
  for (const std::string value : {"2", "4"}) {
    for (PlannedRun run : plan.runs) {
      run.point = "radio.range_m=" + value;
      run.values = {value};
      grid.runs.push_back(run);
    }
  }
  return grid;
}

}  // namespace caravan::experiment
