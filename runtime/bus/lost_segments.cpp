// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/lost_segments.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <string_view>

#include "runtime/bus/fastdds_version.hpp"

namespace caravan::runtime {
namespace {

/// Whether it is the name of a segment of messages, not of a port: the mark and 16 hexadecimal digits.
bool names_segment(std::string_view name) {
  if (name.starts_with('/')) name.remove_prefix(1);
  if (!name.starts_with(kSharedMemoryMark)) return false;
  name.remove_prefix(std::string_view{kSharedMemoryMark}.size());
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  return name.size() == 16 && std::all_of(name.begin(), name.end(), is_digit);
}

/// Anonymous memory that Boost accepts as a segment, with zeroes at every address that a message can have.
/// Only written pages take memory. @return its descriptor; -1: errno gives the reason
int empty_segment() {
  constexpr std::uint32_t kInitialized = 2;  // Boost.Interprocess: the first word of a segment in use
  // Addresses have 32 bits. A segment whose size behind its first words needs more is not opened by Boost,
  // and Fast DDS does not check that.
  constexpr off_t kSize = off_t{1} << 32;
  const int memory = memfd_create("caravan lost segment", MFD_CLOEXEC);
  if (memory < 0) return -1;
  if (ftruncate(memory, kSize) == 0 &&
      pwrite(memory, &kInitialized, sizeof kInitialized, 0) == sizeof kInitialized)
    return memory;
  const int error = errno;
  close(memory);
  errno = error;
  return -1;
}

}  // namespace

bool reads_past_lost_segments() { return kStopsAtLostSegments; }

}  // namespace caravan::runtime

/// Replaces that of the C library, for all libraries of the process.
extern "C" __attribute__((visibility("default"))) int shm_open(const char* name, int flags, mode_t mode) {
  using Open = int (*)(const char*, int, mode_t);
  static const auto open_of_library = reinterpret_cast<Open>(dlsym(RTLD_NEXT, "shm_open"));
  const int memory = open_of_library(name, flags, mode);
  const bool is_lost = memory < 0 && errno == ENOENT && (flags & O_CREAT) == 0;
  if (!caravan::runtime::reads_past_lost_segments() || !is_lost || !caravan::runtime::names_segment(name))
    return memory;
  return caravan::runtime::empty_segment();
}
