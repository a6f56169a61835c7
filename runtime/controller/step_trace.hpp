// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/types.hpp>
#include <cstdint>
#include <filesystem>

#include "runtime/pure/canonical_bytes.hpp"
#include "runtime/trace/trace_file.hpp"

namespace caravan::runtime {

/// File of what one robot's controller is given and answers, in `folder`; docs/digest.md describes it. It
/// begins anew with each StepTrace.
///
/// What was recorded survives the death of the process, so that the inputs of a step that crashes are there.
class StepTrace {
 public:
  /// @throws StartError when the file cannot be written
  StepTrace(const std::filesystem::path& folder, std::uint32_t robot);

  /// A step begins. Without Inputs::destination, which follows from the rest.
  /// @throws WriteError, as answer() does
  void ask(const Inputs& inputs);
  /// The step has ended. Without Outputs::report.
  void answer(const Outputs& outputs);

 private:
  void record();

  TraceFile file_;
  pure::CanonicalBytes bytes_;
};

}  // namespace caravan::runtime
