// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace caravan::runtime {

/// What a participant says of itself in discovery; carried in its DDS name.
struct Identity {
  std::string role;  ///< "world_server", "radio_emulator", "robot_agent 3", ...
  std::string host;
  std::uint32_t pid = 0;
  std::uint64_t started_ms = 0;  ///< wall clock
  bool operator==(const Identity&) const = default;
};

/// This process, now.
[[nodiscard]] Identity own_identity(const std::string& role);
[[nodiscard]] std::string to_name(const Identity& identity);
/// A stranger's name, one that to_name() did not make, becomes the role of an identity that is otherwise
/// empty.
[[nodiscard]] Identity to_identity(const std::string& name);
/// What others say of themselves, fit for a log: what is not printable ASCII becomes ?, and it
/// is cut off after 80.
[[nodiscard]] std::string printable(const std::string& text);

}  // namespace caravan::runtime
