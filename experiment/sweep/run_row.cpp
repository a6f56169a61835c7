// SPDX-License-Identifier: Apache-2.0
#include "experiment/sweep/run_row.hpp"

#include <nlohmann/json.hpp>

#include "experiment/metrics/run_directory.hpp"
#include "experiment/metrics/text_file.hpp"
#include "experiment/sweep/quantities.hpp"
#include "runtime/config/start_error.hpp"

namespace caravan::experiment {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::string kFailureFile = "failure.txt";

/// Empty: the paper's agent. @throws std::exception
std::string controller_sha256_in(const Json& metrics) {
  const Json& controller = metrics.at("provenance").at("controller");
  return controller.is_null() ? "" : controller.at("sha256").get<std::string>();
}

/// @throws std::exception when a value is missing or has the wrong type
RunRow row_in(const Json& metrics, const PlannedRun& run) {
  if (!metrics.at("ended").get<bool>() || metrics.at("interrupted").get<bool>()) return {};
  if (const auto failure = metrics.at("failure").get<std::string>(); !failure.empty()) {
    return {.state = RunState::kFailed, .reason = failure};
  }
  if (!run.controller_sha256.empty() && controller_sha256_in(metrics) != run.controller_sha256) {
    return {.state = RunState::kFailed,
            .reason =
                "the controller's file was another one than when the sweep began; put that one back and "
                "use --retry-failed"};
  }
  return {.state = RunState::kDone,
          .digest = metrics.at("digest").get<std::string>(),
          .values = values_in(metrics)};
}

}  // namespace

std::string to_text(RunState state) {
  switch (state) {
    case RunState::kPending:
      return "pending";
    case RunState::kRunning:
      return "running";
    case RunState::kDone:
      return "done";
    case RunState::kFailed:
      return "failed";
  }
  return "";
}

RunRow look_at(const fs::path& sweep_folder, const PlannedRun& run) {
  const fs::path folder = sweep_folder / folder_of(run);
  if (std::error_code error; fs::exists(folder, error) && !fs::is_directory(folder, error)) {
    throw runtime::StartError{folder.string() +
                              ": is a file where the folder of a run belongs; move it away"};
  }
  if (const auto scenario = text_in(folder / "scenario.toml"); scenario && *scenario != run.scenario_text) {
    throw runtime::StartError{folder.string() + ": holds a run of another scenario; choose another --out"};
  }
  if (const auto reason = text_in(folder / kFailureFile)) {
    return {.state = RunState::kFailed, .reason = *reason};
  }
  const fs::path file = folder / "metrics.json";
  const auto metrics = text_in(file);
  if (!metrics) return {};
  const Json read = Json::parse(*metrics, nullptr, false);
  if (read.is_discarded()) return {};  // half written because of a power failure: treated as not ended
  try {
    return row_in(read, run);
  } catch (const std::exception& error) {
    return {.state = RunState::kFailed,
            .reason = file.filename().string() + " is not the output of a run: " + error.what()};
  }
}

void note_failure(const fs::path& sweep_folder, const PlannedRun& run, const std::string& reason) {
  const fs::path folder = sweep_folder / folder_of(run);
  fs::create_directories(folder);
  write_whole_file(folder / kFailureFile, reason);
}

}  // namespace caravan::experiment
