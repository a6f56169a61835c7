// SPDX-License-Identifier: Apache-2.0
#include "deploy/sweep/run_row.hpp"

#include <nlohmann/json.hpp>

#include "deploy/metrics/run_directory.hpp"
#include "deploy/metrics/text_file.hpp"
#include "deploy/sweep/quantities.hpp"
#include "runtime/config/start_error.hpp"

namespace caravan::deploy {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::string kFailureFile = "failure.txt";

/// @throws Json::exception when something is missing
RunRow row_in(const Json& metrics) {
  if (!metrics.at("ended").get<bool>() || metrics.at("interrupted").get<bool>()) return {};
  if (const auto failure = metrics.at("failure").get<std::string>(); !failure.empty()) {
    return {.state = RunState::kFailed, .reason = failure};
  }
  return {.state = RunState::kDone,
          .digest = metrics.at("digest").get<std::string>(),
          .values = values_in(metrics)};
}

}  // namespace

std::string in_words(RunState state) {
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
  if (const auto scenario = text_in(folder / "scenario.toml"); scenario && *scenario != run.scenario_text) {
    throw runtime::StartError{folder.string() + ": holds a run of another scenario; choose another --out"};
  }
  if (const auto reason = text_in(folder / kFailureFile)) {
    return {.state = RunState::kFailed, .reason = *reason};
  }
  const auto metrics = text_in(folder / "metrics.json");
  if (!metrics) return {};
  try {
    return row_in(Json::parse(*metrics));
  } catch (const Json::exception&) {
    return {};  // half written, by a file system that lost power: as if the run had not ended
  }
}

void note_failure(const fs::path& sweep_folder, const PlannedRun& run, const std::string& reason) {
  const fs::path folder = sweep_folder / folder_of(run);
  fs::create_directories(folder);
  write_whole_file(folder / kFailureFile, reason);
}

}  // namespace caravan::deploy
