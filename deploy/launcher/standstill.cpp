// SPDX-License-Identifier: Apache-2.0
#include "deploy/launcher/standstill.hpp"

#include <chrono>
#include <vector>

namespace caravan::deploy {
namespace {

using namespace std::chrono_literals;
using caravan_interfaces::msg::WorldStatus;

constexpr auto kSayEvery = 5s;
constexpr auto kSilent = 3s;  // the world sends at least once a second
constexpr auto kGivenUp = 60s;

std::string seconds(std::chrono::nanoseconds time) {
  return std::to_string(std::chrono::duration_cast<std::chrono::seconds>(time).count()) + " s";
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string reason(const std::optional<WorldStatus>& world, std::chrono::nanoseconds silence) {
  if (!world) return "world_server has not been received yet";
  if (silence > kSilent) return "world_server has been silent for " + seconds(silence);
  if (world->paused()) return "the run is paused; `caravan ctl resume` continues it";
  if (!world->hung().empty()) return listed(world->hung()) + " does not answer";
  if (!world->missing().empty()) return listed(world->missing()) + " is missing";
  if (!world->held().empty()) return world->held();
  if (world->members() == 0) return listed(world->gone()) + " is gone, and no other robot is left";
  return "the world gives no reason";
}

}  // namespace

std::optional<std::string> Standstill::say(runtime::WallTime now, const std::optional<WorldStatus>& world) {
  if (now - stepped_ < kSayEvery || now - told_ < kSayEvery) return std::nullopt;
  told_ = now;
  return "no step for " + seconds(now - stepped_) + ": " + reason(world, now - heard_);
}

std::optional<std::string> Standstill::give_up(runtime::WallTime now,
                                               const std::optional<WorldStatus>& world) const {
  if (!world) return std::nullopt;  // the start has its own deadline
  if (now - heard_ >= kGivenUp)
    return "world_server has been silent for " + seconds(now - heard_) + ": the run is given up";
  const bool is_empty = world->members() == 0 && !world->gone().empty() && !world->paused();
  if (!is_empty || now - stepped_ < kGivenUp) return std::nullopt;
  return listed(world->gone()) + " is gone, and no robot has been left for " + seconds(now - stepped_) +
         ": the run is given up";
}

}  // namespace caravan::deploy
