// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace caravan::runtime {

/// Whether a living process has a DDS port of the domain mapped: the domain is in use, by whomever.
[[nodiscard]] bool has_living_ports(std::uint32_t domain);
/// Removes the domain's DDS port files that no living process has mapped. A process that was killed while it
/// made a port leaves one at which every later participant of the domain would hang.
/// @pre nobody is starting in the domain
void remove_dead_ports(std::uint32_t domain);

struct LeftFile {
  std::string name;  ///< in the folder
  std::uint64_t bytes = 0;
};

/// DDS files, of whatever domain or program, that the present user may remove and that nobody alive has
/// mapped or locked, in containers too. Those made within the last minute are spared: somebody may be
/// starting.
[[nodiscard]] std::vector<LeftFile> left_by_the_dead(const std::filesystem::path& folder = "/dev/shm");
/// Removes them. @return how many
std::size_t remove_left_by_the_dead(const std::filesystem::path& folder = "/dev/shm");

/// The shared-memory files that a run's processes leave behind when they are killed.
///
/// A killed process cannot remove its DDS segments, so they are noted while it lives. Only files of the run's
/// domain and of noted processes are removed, and of these only those that no living process has mapped or,
/// of segments, that the process which made them no longer holds.
class SharedMemory {
 public:
  explicit SharedMemory(std::uint32_t domain) : domain_{domain} {}
  /// Removes the leftovers; the run's own participant must be closed by then.
  ~SharedMemory() { remove_leftovers(); }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  /// Remembers the DDS segments that the process has mapped now.
  void note(pid_t process);
  /// The same of those of these that had none yet when they were last looked at: one that is killed early
  /// leaves its segment too. @return have all of them one?
  bool note_new(const std::vector<pid_t>& processes);

 private:
  void remove_leftovers() const;

  std::uint32_t domain_;
  std::set<std::string> segments_;  // file names in /dev/shm
  std::set<pid_t> noted_;           // that had some
};

}  // namespace caravan::runtime
