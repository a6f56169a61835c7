// SPDX-License-Identifier: Apache-2.0
#include "runtime/process/data_folder.hpp"

namespace caravan::runtime {

std::filesystem::path data_folder() {
  const auto program = std::filesystem::read_symlink("/proc/self/exe");
  return program.parent_path().parent_path() / "share/caravan";
}

}  // namespace caravan::runtime
