// SPDX-License-Identifier: Apache-2.0
#include "experiment/report/write_report.hpp"

#include <string>

#include "experiment/report/python_program.hpp"

namespace caravan::experiment {
namespace {

/// Long enough for the figures of a large sweep.
constexpr std::chrono::seconds kPatience{1800};

}  // namespace

int write_report(const std::vector<std::filesystem::path>& folders,
                 const std::optional<std::filesystem::path>& out) {
  std::vector<std::string> arguments;
  if (out) arguments = {"--out", out->string()};
  arguments.emplace_back("--");
  for (const std::filesystem::path& folder : folders) arguments.push_back(folder.string());
  return run_python(
      {.caller = "caravan report", .file = "report.py", .arguments = arguments, .patience = kPatience});
}

}  // namespace caravan::experiment
