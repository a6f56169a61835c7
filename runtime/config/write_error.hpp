// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <stdexcept>

namespace caravan::runtime {

/// A file can no longer be written: one line that says which, why and what to do. Becomes exit code 1.
struct WriteError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// @param reason  an error number such as ENOSPC; 0: unknown
[[nodiscard]] WriteError cannot_write(const std::filesystem::path& file, int reason);

}  // namespace caravan::runtime
