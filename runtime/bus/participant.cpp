// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/participant.hpp"

#include <cstdio>

namespace caravan::runtime {

std::string to_text(const ParticipantId& id) {
  std::string text;
  for (const std::uint8_t byte : id.prefix) {
    std::array<char, 4> digits{};
    std::snprintf(digits.data(), digits.size(), text.empty() ? "%02x" : ".%02x", byte);
    text += digits.data();
  }
  return text;
}

std::string to_text(const ParticipantId& id, const Identity& identity) {
  std::string process;
  if (identity.pid != 0) process += " pid " + std::to_string(identity.pid);
  if (!identity.host.empty()) process += " on host " + identity.host;
  if (identity.started_ms != 0) return identity.role + process;
  const std::string name = identity.role.empty() ? "" : " \"" + identity.role + "\"";
  return "participant " + to_text(id) + name + process;
}

}  // namespace caravan::runtime
