// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/shell/sole_server.hpp"

#include <spdlog/spdlog.h>

namespace caravan::bridge {

using Kind = runtime::Discovery::Kind;

SoleServer::SoleServer(const runtime::Bus& bus, double lease_s, const idl::Topic& topic, std::uint32_t robot)
    : topic_{topic},
      robot_{robot},
      clash_{bus.id(), bus.identity(), lease_s, std::chrono::steady_clock::now()} {}

void SoleServer::see(const runtime::Discovery& news, bool in_use) {
  const std::string name = idl::name_for(topic_, robot_);
  if (news.kind == Kind::kGone || (news.kind == Kind::kWriterGone && news.topic == name))
    clash_.vanished(news.participant);
  if (news.kind != Kind::kWriterFound || news.topic != name ||
      claim_of(topic_, news.identity) == runtime::Claim::kNone) {
    return;
  }
  if (clash_.found(robot_, news.participant, news.identity, in_use, std::chrono::steady_clock::now())) return;
  spdlog::warn("{} has another writer: {}; the one whose samples came first counts", name,
               to_text(news.participant, news.identity));
}

std::string SoleServer::lost() const {
  const auto holder = clash_.lost_to(std::chrono::steady_clock::now());
  if (!holder) return "";
  return "robot " + std::to_string(robot_) + " is already served by " + holder->identity.role + ", pid " +
         std::to_string(holder->identity.pid) + " on host " + holder->identity.host +
         ": end that one first, or choose another --robot";
}

}  // namespace caravan::bridge
