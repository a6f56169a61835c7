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

/// One run as the command line asked for it, checked: what either engine is given.
struct RunRequest {
  RunFacts facts;
  runtime::TomlDocument scenario;       ///< effective: the file with the command line's changes
  std::filesystem::path folder;         ///< exists, this run's own, absolute
  std::filesystem::path scenario_file;  ///< the effective scenario in it, for other processes to read
  std::uint32_t domain = 0;             ///< of the dds engine: DDS domain, held by the caller
  runtime::Transport transport = runtime::Transport::kSharedMemory;
  std::uint32_t agents_per_process = 1;
  std::optional<std::filesystem::path>
      trace;  ///< folder, existing, for the trace of every step; none: no trace
  bool quiet = false;
  runtime::Loop& loop;  ///< says when SIGINT or SIGTERM came
};

/// The two files of a trace.
[[nodiscard]] inline std::filesystem::path world_trace_in(const std::filesystem::path& folder) {
  return folder / "world.trace";
}
[[nodiscard]] inline std::filesystem::path radio_trace_in(const std::filesystem::path& folder) {
  return folder / "radio.trace";
}

}  // namespace caravan::experiment
