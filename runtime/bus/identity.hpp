// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace caravan::runtime {

/// The identity that a participant states in discovery; carried in its DDS name.
struct Identity {
  std::string role;  ///< "world_server", "radio_emulator", "robot_agent 3", ...
  std::string host;
  std::uint32_t pid = 0;
  std::uint64_t started_ms = 0;  ///< wall clock
  bool operator==(const Identity&) const = default;
};

/// Identity of this process.
[[nodiscard]] Identity own_identity(const std::string& role);
[[nodiscard]] std::string to_name(const Identity& identity);
/// Parses a name made by to_name(). Any other name becomes the role of an identity that is otherwise empty.
[[nodiscard]] Identity to_identity(const std::string& name);
/// A participant's text, safe for a log: replaces anything but printable ASCII with ?, and cuts it off after
/// 80 characters.
[[nodiscard]] std::string printable(const std::string& text);

}  // namespace caravan::runtime
