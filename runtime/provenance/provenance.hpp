// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runtime/provenance/commit.hpp"

namespace caravan::runtime {

/// The program, as built. It contains neither times nor paths of the build.
struct Build {
  std::string version;
  Commit commit;
  std::string compiler;  ///< its name and version
  std::string type;      ///< Release, RelWithDebInfo, ...
  std::string flags;     ///< of the compiler, without warnings
  /// Versions by name: those built with, and the C library in use.
  std::map<std::string, std::string> libraries;
};

/// The machine on which the command runs.
struct Host {
  std::string processor;  ///< model
  std::string architecture;
  std::uint64_t cores = 0;
  std::string kernel;
  std::string release;  ///< of the distribution
};

struct HashedFile {
  std::string file;  ///< absolute path
  std::string sha256;
};

/// What made a run: enough to repeat it, and to name what was different when it comes out differently.
struct Provenance {
  Build build;
  Host host;
  std::vector<std::string> command_line;
  std::map<std::string, std::uint64_t> seeds;  ///< by the key of the scenario
  std::string scenario_sha256;                 ///< of the effective scenario's text, scenario.toml
  std::string transport;                       ///< as on a command line; with the embedded engine unused
  std::uint32_t agents_per_process = 1;
  std::optional<HashedFile> controller;  ///< none: the paper's agent
  std::optional<HashedFile> agent;       ///< program in the place of robot_agent; none: robot_agent
};

}  // namespace caravan::runtime
