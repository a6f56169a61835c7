// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "runtime/provenance/provenance.hpp"

namespace caravan::experiment {

/// What the folder of a run says about it, as far as a repetition needs it.
struct RecordedRun {
  std::string engine;  ///< dds, embedded
  std::string digest;
  bool ended = false;
  bool interrupted = false;
  bool disturbed = false;
  std::string failure;  ///< empty: none
  runtime::Provenance provenance;
};

/// @throws runtime::StartError when the folder has no metrics.json, or one that is damaged or says nothing of
/// its provenance
[[nodiscard]] RecordedRun read_recorded_run(const std::filesystem::path& folder);

}  // namespace caravan::experiment
