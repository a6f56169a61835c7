// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/radio/frames/text.hpp"

#include "runtime/pure/overload.hpp"

namespace caravan::agent {
namespace {

template <typename Addressed>
std::string with_address(const char* name, const Addressed& message) {
  return std::string{name} + '_' + std::to_string(message.from.value) + '-' +
         std::to_string(message.to.value);
}

std::string presence(const Wait& wait) {
  if (wait.engagement != Engagement::kFree) return "BUSY";
  return wait.mode == Mode::kExplore ? "EXPLORE" : "TRANSPORT";
}

std::string extent(const PathFragment& path) {
  const std::string total = '/' + std::to_string(path.total);
  if (path.points.empty()) return '-' + total;
  return std::to_string(path.first) + ".." + std::to_string(path.first + path.points.size() - 1) + total;
}

}  // namespace

std::string to_text(const Message& message) {
  return std::visit(
      pure::Overload{
          [](const Wait& wait) { return "WAIT_" + std::to_string(wait.from.value) + '_' + presence(wait); },
          [](const Accept& accept) { return with_address("ACCEPT", accept); },
          [](const AcceptAck& ack) { return with_address("ACCEPTACK", ack); },
          [](const Reject& reject) { return with_address("REJECT", reject); },
          [](const PathFragment& path) { return with_address("PATH", path) + '_' + extent(path); },
          [](const End& end) { return with_address("END", end); },
      },
      message);
}

}  // namespace caravan::agent
