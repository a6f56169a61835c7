// SPDX-License-Identifier: Apache-2.0
#include "runtime/host/shared_memory.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <fstream>

#include "runtime/bus/shared_memory_port.hpp"

namespace caravan::runtime {
namespace fs = std::filesystem;
namespace {

const fs::path kFolder{"/dev/shm"};

/// Prefix of the names of DDS's ports.
const std::string& port_mark() {
  static const std::string mark = shared_memory_mark() + "port";
  return mark;
}

/// DDS files in `folder` that a process has mapped.
std::set<std::string> mapped_by(const fs::path& process, const fs::path& folder = kFolder) {
  std::set<std::string> names;
  std::ifstream maps{process / "maps"};
  const std::string mark = folder.string() + "/";
  for (std::string line; std::getline(maps, line);) {
    const std::size_t place = line.find(mark);
    if (place == std::string::npos || line.find(shared_memory_mark()) == std::string::npos) continue;
    std::string name = line.substr(place + mark.size());
    names.insert(name.substr(0, name.find(' ')));  // the kernel adds " (deleted)"
  }
  return names;
}

/// Files in `folder` that a process has open.
std::set<std::string> opened_by(const fs::path& process, const fs::path& folder) {
  std::set<std::string> names;
  std::error_code error;
  for (const auto& descriptor : fs::directory_iterator{process / "fd", error}) {
    const fs::path file = fs::read_symlink(descriptor.path(), error);
    if (!error && file.parent_path() == folder) names.insert(file.filename());
  }
  return names;
}

/// DDS files in `folder` that a running process has open or mapped.
///
/// A starting process opens a file, maps it, and closes it. Since open files are read before mapped ones, a
/// file that existed before this call is seen at each of these steps.
std::set<std::string> used_by_the_living(const fs::path& folder = kFolder) {
  std::set<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator{"/proc", error}) {
    const std::string name = entry.path().filename();
    if (!std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c) != 0; }))
      continue;
    names.merge(opened_by(entry.path(), folder));
    names.merge(mapped_by(entry.path(), folder));
  }
  return names;
}

/// Whether the file belongs to a port of the domain.
bool is_of_a_port_of(const std::string& name, std::uint32_t domain) {
  const std::size_t place = name.find(port_mark());
  if (place == std::string::npos) return false;
  std::uint32_t port = 0;
  const char* digits = name.data() + place + port_mark().size();
  if (std::from_chars(digits, name.data() + name.size(), port).ec != std::errc{}) return false;
  return is_port_of(port, domain);
}

/// A segment's file has the name of the segment; its lock has the suffix "_el".
std::string without_lock_mark(const std::string& name) {
  return name.ends_with("_el") ? name.substr(0, name.size() - 3) : name;
}

/// The segment that a file belongs to: itself, or that of a lock (_el, _sl) or a semaphore (sem.*_mutex).
std::string segment_of(std::string name) {
  if (name.starts_with("sem.")) name = name.substr(4);
  for (const std::string_view mark : {"_el", "_sl", "_mutex"}) {
    if (name.ends_with(mark)) name.resize(name.size() - mark.size());
  }
  return name;
}

/// Removes those of our files that no running process uses. The list of files is made first: a process that
/// starts meanwhile creates others.
template <typename Ours>
void remove_unused(Ours is_ours, const fs::path& folder = kFolder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator{folder, error}) {
    const std::string name = entry.path().filename();
    if (is_ours(name)) names.push_back(name);
  }
  if (names.empty()) return;
  const std::set<std::string> in_use = used_by_the_living(folder);
  for (const std::string& name : names) {
    if (!in_use.contains(name) && !in_use.contains(without_lock_mark(name))) fs::remove(folder / name, error);
  }
}

bool is_locked(const fs::path& file) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool locked = flock(descriptor, LOCK_EX | LOCK_NB) != 0;
  close(descriptor);  // also releases our own lock
  return locked;
}

/// Whether a process that is not visible here, such as one in another container, holds DDS's lock on it.
bool is_held(const fs::path& folder, const std::string& segment) {
  return is_locked(folder / (segment + "_el")) || is_locked(folder / (segment + "_sl"));
}

/// Whether the user may remove it, and it is too old to belong to a starting process.
bool is_ours_and_old(const fs::path& file) {
  constexpr std::time_t kOld_s = 60;
  struct stat facts {};
  if (stat(file.c_str(), &facts) != 0) return false;
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return (geteuid() == 0 || facts.st_uid == geteuid()) && now - facts.st_mtime > kOld_s;
}

}  // namespace

void SharedMemory::note(pid_t process) {
  for (const std::string& name : mapped_by(fs::path{"/proc"} / std::to_string(process))) {
    if (name.find(port_mark()) != std::string::npos) continue;
    segments_.insert(name);
    noted_.insert(process);
  }
}

bool SharedMemory::note_new(const std::vector<pid_t>& processes) {
  bool all = true;
  for (const pid_t process : processes) {
    if (!noted_.contains(process)) note(process);
    all = all && noted_.contains(process);
  }
  return all;
}

void SharedMemory::remove_leftovers() const {
  remove_unused([this](const std::string& name) {
    return is_of_a_port_of(name, domain_) || segments_.contains(without_lock_mark(name));
  });
  // DDS never releases the segment of a process that it has received from, so this one still has it mapped.
  // The lock shows whether its creator is alive.
  std::error_code error;
  for (const std::string& segment : segments_) {
    if (is_held(kFolder, segment)) continue;
    fs::remove(kFolder / segment, error);
    fs::remove(kFolder / (segment + "_el"), error);
  }
}

bool has_living_ports(std::uint32_t domain) {
  const std::set<std::string> in_use = used_by_the_living();
  return std::any_of(in_use.begin(), in_use.end(),
                     [&](const std::string& name) { return is_of_a_port_of(name, domain); });
}

std::vector<LeftFile> left_by_the_dead(const fs::path& folder) {
  const std::set<std::string> in_use = used_by_the_living(folder);
  std::vector<LeftFile> left;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator{folder, error}) {
    const std::string name = entry.path().filename();
    const std::string segment = segment_of(name);
    if (!segment.starts_with(shared_memory_mark()) || in_use.contains(name) || in_use.contains(segment))
      continue;
    if (!is_ours_and_old(entry.path()) || is_held(folder, segment)) continue;
    left.push_back({name, fs::file_size(entry.path(), error)});
  }
  std::sort(left.begin(), left.end(), [](const LeftFile& a, const LeftFile& b) { return a.name < b.name; });
  return left;
}

std::size_t remove_left_by_the_dead(const fs::path& folder) {
  std::size_t removed = 0;
  std::error_code error;
  for (const LeftFile& file : left_by_the_dead(folder))
    removed += fs::remove(folder / file.name, error) ? 1U : 0U;
  return removed;
}

void remove_dead_ports(std::uint32_t domain, const fs::path& folder) {
  remove_unused([domain](const std::string& name) { return is_of_a_port_of(name, domain); }, folder);
}

}  // namespace caravan::runtime
