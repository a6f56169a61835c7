// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace caravan::runtime {

/// Whether a running process, of any user, has a DDS port of the domain open or mapped: the domain is in use.
[[nodiscard]] bool has_living_ports(std::uint32_t domain);
/// Removes the domain's DDS port files that no running process has open or mapped. A process that is killed
/// while it creates a port leaves one at which every later participant of the domain would hang. Processes
/// may start in the domain meanwhile.
void remove_dead_ports(std::uint32_t domain, const std::filesystem::path& folder = "/dev/shm");

struct LeftFile {
  std::string name;  ///< file name in the folder
  std::uint64_t bytes = 0;
};

/// DDS files, of any domain or program, that the present user may remove and that no running process has
/// open, mapped or locked, including containers. Files created within the last minute are skipped: a process
/// may be starting.
[[nodiscard]] std::vector<LeftFile> left_by_the_dead(const std::filesystem::path& folder = "/dev/shm");
/// Removes these files. @return how many
std::size_t remove_left_by_the_dead(const std::filesystem::path& folder = "/dev/shm");

/// The shared-memory files that a run's processes leave behind when they are killed.
///
/// A killed process cannot remove its DDS segments, so they are noted while it is running. Only files of the
/// run's domain and of noted processes are removed, and of these only those that no running process has
/// open or mapped; of segments, only those that their creator no longer holds.
class SharedMemory {
 public:
  explicit SharedMemory(std::uint32_t domain) : domain_{domain} {}
  /// Removes the leftovers; the run's own participant must be closed by then.
  ~SharedMemory() { remove_leftovers(); }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  /// Remembers the DDS segments that the process has mapped now.
  void note(pid_t process);
  /// The same, only for processes that had no segment when last checked: a process that is killed early
  /// leaves its segment too. @return whether all of them have one
  bool note_new(const std::vector<pid_t>& processes);

 private:
  void remove_leftovers() const;

  std::uint32_t domain_;
  std::set<std::string> segments_;  // file names in /dev/shm
  std::set<pid_t> noted_;           // processes that had segments
};

}  // namespace caravan::runtime
