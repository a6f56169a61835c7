// SPDX-License-Identifier: Apache-2.0
#include "runtime/process/data_folder.hpp"

namespace caravan::runtime {
namespace {

std::filesystem::path share() {
  const auto program = std::filesystem::read_symlink("/proc/self/exe");
  return program.parent_path().parent_path() / "share";
}

}  // namespace

std::filesystem::path data_folder() { return share() / "caravan"; }

std::string page(const std::string& name) { return share() / "doc/caravan/docs" / name; }

}  // namespace caravan::runtime
