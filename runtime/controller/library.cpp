// SPDX-License-Identifier: Apache-2.0
#include "runtime/controller/library.hpp"

#include <dlfcn.h>

#include "runtime/config/start_error.hpp"

namespace caravan::runtime {
namespace {

constexpr const char* kEntryPoint = "caravan_controller";
using EntryPoint = const ControllerLibrary* (*)();

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason) {
  throw StartError{"controller " + file.string() + ": " + reason};
}

}  // namespace

const ControllerLibrary& load_controller(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    refuse(file, std::filesystem::exists(file, error) ? "is not a file" : "there is no such file");
  // An absolute path, because dlopen() searches the system's folders for a bare name.
  void* handle = dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) refuse(file, std::string{"cannot be loaded: "} + dlerror());
  const auto entry_point = reinterpret_cast<EntryPoint>(dlsym(handle, kEntryPoint));
  if (entry_point == nullptr)
    refuse(file, "does not export " + std::string{kEntryPoint} +
                     "(): add CARAVAN_CONTROLLER(Class, \"name\") to it");
  const ControllerLibrary* library = nullptr;
  try {
    library = entry_point();
  } catch (...) {
    refuse(file, std::string{kEntryPoint} + "() threw an exception");
  }
  if (library == nullptr) refuse(file, std::string{kEntryPoint} + "() returned no library");
  if (library->interface != kControllerInterface) {
    refuse(file, "was built for version " + std::to_string(library->interface) +
                     " of the controller interface, this program has version " +
                     std::to_string(kControllerInterface) + ": build it anew");
  }
  if (library->make == nullptr) refuse(file, "has no function that makes a controller");
  return *library;
}

}  // namespace caravan::runtime
