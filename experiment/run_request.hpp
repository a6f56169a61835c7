// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "experiment/metrics/run_facts.hpp"
#include "runtime/bus/transport.hpp"
#include "runtime/config/toml_table.hpp"
#include "runtime/process/loop.hpp"

namespace caravan::experiment {

/// One run as requested on the command line, checked: the input of either engine.
struct RunRequest {
  RunFacts facts;
  runtime::TomlDocument scenario;       ///< effective: the file with the command line's changes
  std::filesystem::path folder;         ///< exists, belongs to this run, absolute
  std::filesystem::path scenario_file;  ///< the effective scenario in it, for other processes to read
  std::uint32_t domain = 0;             ///< for the dds engine: DDS domain, held by the caller
  runtime::Transport transport = runtime::Transport::kSharedMemory;
  std::filesystem::path agent = {};  ///< of the dds engine: program in the place of robot_agent; empty: none
  std::uint32_t agents_per_process = 1;
  std::optional<std::filesystem::path>
      trace;  ///< existing folder for the trace of every step; none: no trace
  bool quiet = false;
  runtime::Loop& loop;  ///< reports SIGINT and SIGTERM
};

/// The two files of a trace.
[[nodiscard]] inline std::filesystem::path world_trace_in(const std::filesystem::path& folder) {
  return folder / "world.trace";
}
[[nodiscard]] inline std::filesystem::path radio_trace_in(const std::filesystem::path& folder) {
  return folder / "radio.trace";
}

}  // namespace caravan::experiment
