// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>

namespace caravan::experiment {

/// Disk space reserved for the final files: a file without a name, which disappears with this process at the
/// latest. On file systems without such files, and on disks without enough space, nothing is reserved.
class SpareRoom {
 public:
  SpareRoom(const std::filesystem::path& folder, std::uint64_t bytes);
  ~SpareRoom() { release(); }
  SpareRoom(const SpareRoom&) = delete;
  SpareRoom& operator=(const SpareRoom&) = delete;

  /// Frees the space for the next writes.
  void release();

 private:
  int descriptor_;  // below 0: nothing is reserved
};

}  // namespace caravan::experiment
