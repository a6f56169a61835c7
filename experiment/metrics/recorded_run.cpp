// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/recorded_run.hpp"

#include <nlohmann/json.hpp>

#include "experiment/metrics/provenance_json.hpp"
#include "experiment/metrics/text_file.hpp"

namespace caravan::experiment {

RecordedRun read_recorded_run(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "metrics.json";
  const auto text = text_in(file);
  if (!text)
    throw runtime::StartError{folder.string() + ": is not the folder of a run: no metrics.json in it"};
  const auto json = nlohmann::json::parse(*text, nullptr, false);
  if (!json.is_object()) throw runtime::StartError{file.string() + ": is damaged: it is not JSON"};
  if (!json.contains("provenance"))
    throw runtime::StartError{file.string() +
                              ": has no provenance: an earlier version wrote it; `caravan run` its "
                              "scenario.toml, and compare the digests"};
  try {
    return {.engine = json.at("engine"),
            .digest = json.at("digest"),
            .ended = json.at("ended"),
            .interrupted = json.at("interrupted"),
            .disturbed = json.at("disturbed"),
            .failure = json.at("failure"),
            .provenance = read_provenance(json.at("provenance"))};
  } catch (const nlohmann::json::exception& error) {
    throw runtime::StartError{file.string() + ": is damaged: " + error.what()};
  }
}

}  // namespace caravan::experiment
