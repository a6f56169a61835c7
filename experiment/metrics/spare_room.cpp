// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/spare_room.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace caravan::experiment {

SpareRoom::SpareRoom(const std::filesystem::path& folder, std::uint64_t bytes)
    : descriptor_{open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600)} {
  if (descriptor_ >= 0 && posix_fallocate(descriptor_, 0, static_cast<off_t>(bytes)) != 0) release();
}

void SpareRoom::release() {
  if (descriptor_ >= 0) close(descriptor_);
  descriptor_ = -1;
}

}  // namespace caravan::experiment
