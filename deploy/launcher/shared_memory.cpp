// SPDX-License-Identifier: Apache-2.0
#include "deploy/launcher/shared_memory.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <fstream>

namespace caravan::deploy {
namespace fs = std::filesystem;
namespace {

const fs::path kFolder{"/dev/shm"};
constexpr std::string_view kPortMark = "fastrtps_port";

/// DDS files in /dev/shm that a process has mapped.
std::set<std::string> mapped_by(const fs::path& process) {
  std::set<std::string> names;
  std::ifstream maps{process / "maps"};
  const std::string mark = kFolder.string() + "/";
  for (std::string line; std::getline(maps, line);) {
    const std::size_t place = line.find(mark);
    if (place == std::string::npos || line.find("fastrtps") == std::string::npos) continue;
    std::string name = line.substr(place + mark.size());
    names.insert(name.substr(0, name.find(' ')));  // the kernel adds " (deleted)"
  }
  return names;
}

std::set<std::string> mapped_by_the_living() {
  std::set<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator{"/proc", error}) {
    const std::string name = entry.path().filename();
    if (!std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c) != 0; }))
      continue;
    names.merge(mapped_by(entry.path()));
  }
  return names;
}

/// Whether the file belongs to a port of the domain: DDS gives each domain 250 port numbers from 7400 on.
bool is_port_of(const std::string& name, std::uint32_t domain) {
  const std::size_t place = name.find(kPortMark);
  if (place == std::string::npos) return false;
  std::uint32_t port = 0;
  const char* digits = name.data() + place + kPortMark.size();
  if (std::from_chars(digits, name.data() + name.size(), port).ec != std::errc{}) return false;
  return port >= 7400 + 250 * domain && port < 7400 + 250 * (domain + 1);
}

/// A segment's file is named like the segment, its lock like it with "_el" behind.
std::string without_lock_mark(const std::string& name) {
  return name.ends_with("_el") ? name.substr(0, name.size() - 3) : name;
}

template <typename Ours>
void remove_unused(Ours is_ours) {
  const std::set<std::string> in_use = mapped_by_the_living();
  std::error_code error;
  for (const auto& entry : fs::directory_iterator{kFolder, error}) {
    const std::string name = entry.path().filename();
    if (!is_ours(name) || in_use.contains(name) || in_use.contains(without_lock_mark(name))) continue;
    fs::remove(entry.path(), error);
  }
}

}  // namespace

void SharedMemory::note(pid_t process) {
  for (const std::string& name : mapped_by(fs::path{"/proc"} / std::to_string(process))) {
    if (name.find(kPortMark) == std::string::npos) segments_.insert(name);
  }
}

void SharedMemory::remove_leftovers() const {
  remove_unused([this](const std::string& name) {
    return is_port_of(name, domain_) || segments_.contains(without_lock_mark(name));
  });
}

bool has_living_ports(std::uint32_t domain) {
  const std::set<std::string> in_use = mapped_by_the_living();
  return std::any_of(in_use.begin(), in_use.end(),
                     [&](const std::string& name) { return is_port_of(name, domain); });
}

void remove_dead_ports(std::uint32_t domain) {
  remove_unused([domain](const std::string& name) { return is_port_of(name, domain); });
}

}  // namespace caravan::deploy
