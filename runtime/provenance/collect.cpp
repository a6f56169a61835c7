// SPDX-License-Identifier: Apache-2.0
#include "runtime/provenance/collect.hpp"

#include <gnu/libc-version.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>

#include "runtime/config/start_error.hpp"
#include "runtime/process/version.hpp"
#include "runtime/provenance/build_settings.hpp"
#include "runtime/provenance/sha256.hpp"

namespace caravan::runtime {
namespace {

constexpr std::string_view kUnknown = "unknown";

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\"";
  const std::size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlank) + 1 - begin);
}

/// The value of the first line `key SEPARATOR value`.
std::optional<std::string> value_in(std::string_view text, std::string_view key, char separator) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    const std::size_t middle = line.find(separator);
    if (middle == std::string_view::npos || trimmed(line.substr(0, middle)) != key) continue;
    const std::string_view value = trimmed(line.substr(middle + 1));
    if (!value.empty()) return std::string{value};
  }
  return std::nullopt;
}

std::string text_of(const char* file) {
  std::ifstream in{file};
  return {std::istreambuf_iterator<char>{in}, {}};
}

std::string one_space_between_words(std::string_view text) {
  std::string line;
  for (const char one : text) {
    if (one != ' ' || (!line.empty() && line.back() != ' ')) line += one;
  }
  if (line.ends_with(' ')) line.pop_back();
  return line;
}

}  // namespace

std::string processor_in(std::string_view cpuinfo) {
  for (const std::string_view key : {"model name", "cpu model", "Model", "Hardware"}) {
    if (auto value = value_in(cpuinfo, key, ':')) return *value;
  }
  return std::string{kUnknown};
}

std::string release_in(std::string_view os_release) {
  return value_in(os_release, "PRETTY_NAME", '=').value_or(std::string{kUnknown});
}

Build this_build() {
  Build build{.version = std::string{kVersion},
              .commit = commit_of_build(),
              .compiler = std::string{kCompiler},
              .type = std::string{kBuildType},
              .flags = one_space_between_words(kCompilerFlags),
              .libraries = {{"glibc", gnu_get_libc_version()}}};
  for (const auto& [name, version] : kBuiltWith) {
    build.libraries.emplace(name, version.empty() ? kUnknown : version);
  }
  return build;
}

Host this_host() {
  utsname system{};
  const bool named = uname(&system) == 0;
  const long cores = sysconf(_SC_NPROCESSORS_ONLN);
  return {.processor = processor_in(text_of("/proc/cpuinfo")),
          .architecture = named ? system.machine : std::string{kUnknown},
          .cores = cores > 0 ? static_cast<std::uint64_t>(cores) : 0,
          .kernel = named ? std::string{system.sysname} + " " + system.release : std::string{kUnknown},
          .release = release_in(text_of("/etc/os-release"))};
}

HashedFile hashed(const std::filesystem::path& file) {
  errno = 0;
  std::ifstream in{file, std::ios::binary};
  Sha256 hash;
  std::array<char, 1U << 16U> part{};
  while (in) {
    in.read(part.data(), part.size());
    hash.add({part.data(), static_cast<std::size_t>(in.gcount())});
  }
  if (!in.eof()) throw StartError{file.string() + ": cannot be read: " + std::strerror(errno)};
  return {.file = file, .sha256 = hash.hex()};
}

}  // namespace caravan::runtime
