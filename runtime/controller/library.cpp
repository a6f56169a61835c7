// SPDX-License-Identifier: Apache-2.0
#include "runtime/controller/library.hpp"

#include <dlfcn.h>

#include <array>
#include <fstream>
#include <string_view>

#include "runtime/config/start_error.hpp"
#include "runtime/controller/floating_point.hpp"
#include "runtime/controller/snake_case.hpp"
#include "runtime/pure/one_line.hpp"

namespace caravan::runtime {
namespace {

constexpr const char* kEntryPoint = "caravan_controller";
using EntryPoint = const ControllerLibrary* (*)();

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason) {
  throw StartError{"controller " + file.string() + ": " + reason};
}

bool is_elf(const std::filesystem::path& file) {
  std::array<char, 4> first{};
  std::ifstream{file, std::ios::binary}.read(first.data(), first.size());
  return std::string_view{first.data(), first.size()} ==
         "\x7f"
         "ELF";
}

/// The text of what dlopen() has just refused.
std::string why_not_loaded() { return std::string{"cannot be loaded: "} + dlerror(); }

bool is_name(std::string_view text) {
  constexpr std::size_t kLongest = 64;
  return text.size() <= kLongest && is_lower_snake_case(text);
}

const ControllerLibrary& load_library(const std::filesystem::path& file) {
  const KeptFloatingPoint kept;  // a library built with -ffast-math flushes to zero as soon as it is loaded
  // An absolute path, because dlopen() searches the system's folders for a bare name.
  void* handle = dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) refuse(file, why_not_loaded());
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
  if (library->name == nullptr) refuse(file, "has no name");
  if (!is_name(library->name)) {
    refuse(file, "has the name \"" + pure::one_line(library->name) +
                     "\", must be lower_snake_case, of 1 to 64 characters");
  }
  return *library;
}

/// Where the host of Python is: beside the programs' folder, or beside that of the library that has this
/// code.
std::filesystem::path python_host(const std::filesystem::path& file) {
  const std::filesystem::path package = "caravan_controller/_host.so";
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  Dl_info here{};
  (void)dladdr(reinterpret_cast<const void*>(&load_controller), &here);
  const std::filesystem::path code =
      std::filesystem::absolute(here.dli_fname == nullptr ? "" : here.dli_fname);
  const std::filesystem::path of_code = code.parent_path().parent_path() / package;
  const std::filesystem::path of_program =
      program.parent_path().parent_path() / "lib/caravan/python" / package;
  for (const std::filesystem::path& host : {of_code, of_program}) {
    if (std::filesystem::is_regular_file(host, error)) return host;
  }
  refuse(file, "is Python, and its host " + of_program.string() + " is missing: build or install it");
}

/// Python's symbols must be visible to all, because extension modules such as NumPy's are not linked with it.
void load_python(const std::filesystem::path& file) {
  if (dlsym(RTLD_DEFAULT, "Py_IsInitialized") != nullptr) return;  // this is a Python program
  if (dlopen(CARAVAN_LIBPYTHON, RTLD_NOW | RTLD_GLOBAL) == nullptr) refuse(file, why_not_loaded());
}

}  // namespace

LoadedController load_controller(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    refuse(file, std::filesystem::exists(file, error) ? "is not a file" : "there is no such file");
  if (file.extension() != ".py") {
    if (!is_elf(file)) refuse(file, "is not a shared library; compile it first");
    const ControllerLibrary& library = load_library(file);
    return {.file = file, .library = &library, .name = library.name};
  }
  load_python(file);
  return {.file = file, .library = &load_library(python_host(file)), .name = file.stem()};
}

}  // namespace caravan::runtime
