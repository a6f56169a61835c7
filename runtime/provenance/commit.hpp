// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace caravan::runtime {

/// State of the source tree at the last build.
struct Commit {
  std::string id;             ///< 40 hex digits, or "unknown": the tree is not in git
  std::optional<bool> dirty;  ///< files were changed since that commit; none: not known
};
/// Defined in a source that the build writes.
[[nodiscard]] Commit commit_of_build();

}  // namespace caravan::runtime
