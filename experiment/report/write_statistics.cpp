// SPDX-License-Identifier: Apache-2.0
#include "experiment/report/write_statistics.hpp"

#include <cstdio>
#include <string>
#include <vector>

#include "experiment/report/python_program.hpp"
#include "runtime/config/start_error.hpp"
#include "runtime/process/run_process.hpp"

namespace caravan::experiment {
namespace {

/// Long enough for thousands of settings.
constexpr std::chrono::seconds kPatience{3600};

}  // namespace

bool write_statistics(const std::filesystem::path& folder, bool quiet, runtime::Loop& loop) {
  remove_comparisons(folder);
  std::vector<std::string> arguments{folder.string()};
  if (quiet) arguments.emplace_back("--quiet");
  try {
    return run_python({.caller = "caravan sweep",
                       .file = "sweep_statistics.py",
                       .arguments = arguments,
                       .patience = kPatience,
                       .loop = &loop}) == runtime::kInterrupted;
  } catch (const runtime::StartError& error) {
    std::fprintf(
        stderr,
        "%s; statistics are left out: summary.csv has no intervals, and there is no comparisons.csv\n",
        error.what());
    return false;
  }
}

void remove_comparisons(const std::filesystem::path& folder) {
  std::error_code not_there;
  std::filesystem::remove(folder / "comparisons.csv", not_there);
}

}  // namespace caravan::experiment
