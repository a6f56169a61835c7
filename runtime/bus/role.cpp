// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/role.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace caravan::runtime {
namespace {

using idl::Party;

/// Keyed by the first word of a role's name; the robot's number follows it.
constexpr std::array<std::pair<std::string_view, Party>, 10> kRoles{{{"world_server", Party::kWorld},
                                                                     {"radio_emulator", Party::kRadio},
                                                                     {"robot_agent", Party::kAgent},
                                                                     {"pioneer_bridge", Party::kBridge},
                                                                     {"radio_modem_bridge", Party::kBridge},
                                                                     {"arcos_robot", Party::kEmulatedRobot},
                                                                     {"launcher", Party::kObserver},
                                                                     {"kit", Party::kObserver},
                                                                     {"ctl", Party::kObserver},
                                                                     {"observer", Party::kObserver}}};

bool may_write(const idl::Topic& topic, Party party) {
  return std::find(topic.writers.begin(), topic.writers.end(), party) != topic.writers.end();
}

}  // namespace

std::optional<Party> stated_role(const Identity& identity) {
  if (identity.started_ms == 0) return std::nullopt;  // not a name that to_name() made
  const std::string_view word = std::string_view{identity.role}.substr(0, identity.role.find(' '));
  const auto* const found =
      std::find_if(kRoles.begin(), kRoles.end(), [&](const auto& role) { return role.first == word; });
  return found == kRoles.end() ? std::nullopt : std::optional{found->second};
}

Claim claim_of(const idl::Topic& topic, const Identity& identity) {
  if (const auto role = stated_role(identity)) return may_write(topic, *role) ? Claim::kFull : Claim::kNone;
  if (may_write(topic, Party::kAgent)) return Claim::kFull;
  return may_write(topic, Party::kBridge) ? Claim::kWeak : Claim::kNone;
}

}  // namespace caravan::runtime
