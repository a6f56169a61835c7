// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>

namespace caravan::experiment {

/// Room on a disk that is kept free for last words: a file without a name, gone with this process at the
/// latest. On file systems that know no such files, and on disks without so much room, nothing is kept.
class SpareRoom {
 public:
  SpareRoom(const std::filesystem::path& folder, std::uint64_t bytes);
  ~SpareRoom() { release(); }
  SpareRoom(const SpareRoom&) = delete;
  SpareRoom& operator=(const SpareRoom&) = delete;

  /// Gives it to whoever writes next.
  void release();

 private:
  int descriptor_;  // below 0: nothing is kept
};

}  // namespace caravan::experiment
