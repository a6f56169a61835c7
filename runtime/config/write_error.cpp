// SPDX-License-Identifier: Apache-2.0
#include "runtime/config/write_error.hpp"

#include <cerrno>
#include <cstring>

namespace caravan::runtime {

WriteError cannot_write(const std::filesystem::path& file, int reason) {
  std::string line = file.string() + ": cannot be written";
  if (reason != 0) line += std::string{": "} + std::strerror(reason);
  if (reason == ENOSPC || reason == EDQUOT) line += "; make room there and start again";
  return WriteError{line};
}

}  // namespace caravan::runtime
