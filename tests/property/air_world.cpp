// SPDX-License-Identifier: Apache-2.0
#include "tests/property/air_world.hpp"

#include <algorithm>

#include "robot_agent/core/radio/frames/codec.hpp"
#include "robot_agent/core/radio/frames/text.hpp"
#include "robot_agent/core/radio/pairing/can_communicate.hpp"
#include "runtime/pure/overload.hpp"

namespace caravan::agent::testing {
namespace {

std::optional<Message> message_in(const Frame& frame) {
  return std::visit(pure::Overload{[](const auto& message) { return std::optional<Message>{message}; },
                                   [](DecodeError) { return std::optional<Message>{}; }},
                    decode(frame.bytes));
}

RobotId receiver_of(const Message& message) {
  return std::visit(pure::Overload{[](const Wait&) { return RobotId{}; },
                                   [](const auto& addressed) { return addressed.to; }},
                    message);
}

}  // namespace

Path path_of(std::uint16_t id, std::size_t points) {
  Path path;
  for (std::size_t index = 0; index < points; ++index) {
    path.push_back(on_grid({0.5 * static_cast<double>(index), 0.001 * id}));
  }
  return path;
}

AirWorld::AirWorld(std::uint64_t seed, const CommunicationSettings& config)
    : now{config.sharing.starts}, config_{config}, random_{seed, 99} {}

void AirWorld::add(std::uint16_t id, Path path) {
  CommunicationSettings own = config_;
  own.id = RobotId{id};
  paths_ever_[id].push_back(path);
  robots_.emplace(id, Robot{own, Communication{own}, std::move(path), {}, {}, Time{-1}, {}, {}, {}, {}, {}});
}

void AirWorld::remove(std::uint16_t id) { robots_.erase(id); }

void AirWorld::restart(std::uint16_t id) {
  Path path = robots_.at(id).path;
  remove(id);
  add(id, std::move(path));
}

void AirWorld::part(std::uint16_t one, std::uint16_t other, bool parted) {
  parted_[std::minmax(one, other)] = parted;
}

bool AirWorld::are_parted(std::uint16_t one, std::uint16_t other) const {
  const auto place = parted_.find(std::minmax(one, other));
  return place != parted_.end() && place->second;
}

void AirWorld::fly() {
  for (const auto& [from, sender] : robots_) {
    for (const auto& [to, receiver] : robots_) {
      if (from == to || are_parted(from, to)) continue;
      for (const Frame& frame : sender.out.frames) {
        if (frame.channel != receiver.out.tuned || random_.chance(weather.loss)) continue;
        const int copies = random_.chance(weather.duplicate) ? 2 : 1;
        for (int copy = 0; copy < copies; ++copy) {
          const double delay = random_.uniform(0.0, static_cast<double>(weather.max_delay_steps + 1));
          flying_.push_back({to, now + kStep * (1 + static_cast<int>(delay)), frame});
        }
      }
    }
  }
}

void AirWorld::run(int steps) {
  for (; steps > 0; --steps) {
    fly();
    now += kStep;
    std::map<std::uint16_t, std::vector<ReceivedFrame>> heard;
    const auto arrived = std::stable_partition(flying_.begin(), flying_.end(),
                                               [this](const Flying& one) { return one.arrives > now; });
    for (auto one = arrived; one != flying_.end(); ++one) {
      heard[one->to].push_back({.channel = one->frame.channel, .bytes = std::move(one->frame.bytes)});
    }
    flying_.erase(arrived, flying_.end());
    for (auto& [id, robot] : robots_) {
      robot.out = robot.communication.step({now, heard[id], robot.path});
      check(id, robot);
    }
  }
}

void AirWorld::breach(std::uint16_t id, const std::string& what) {
  breaches.push_back("at " + std::to_string(now.count() / 1000000) + " ms robot " + std::to_string(id) +
                     ": " + what);
}

void AirWorld::check(std::uint16_t id, Robot& robot) {
  check_frames(id, robot);
  check_exchanges(id, robot);
  if (robot.still_since >= Time{0}) {
    const Time still = now - robot.still_since;
    const Time bound =
        config_.sharing.accept_period * config_.sharing.accept_attempts + config_.sharing.session_timer;
    if (still > bound + kStep) breach(id, "stands still too long");
    robot.longest_still = std::max(robot.longest_still, still);
    robot.stood += kStep;
  }
  if (!robot.out.stand_still) robot.still_since = Time{-1};
  if (robot.out.stand_still && robot.still_since < Time{0}) robot.still_since = now;
}

/// A robot has at most one partner, respects the limits of the radio, and does what its WAIT says.
void AirWorld::check_frames(std::uint16_t id, Robot& robot) {
  std::optional<RobotId> partner;
  bool says_wait = false;
  for (const Frame& frame : robot.out.frames) {
    const auto message = message_in(frame);
    if (!message) return breach(id, "sends what nobody understands");
    if (frame.bytes.size() > config_.air.mtu_bytes) breach(id, "exceeds the MTU with " + to_text(*message));
    if (frame.channel.value >= config_.air.channel_count)
      breach(id, "sends on a channel that does not exist");
    if (const auto* wait = std::get_if<Wait>(&*message)) {
      robot.presence = *wait;
      says_wait = true;
      if (frame.channel != kCommonChannel) breach(id, "says WAIT elsewhere");
    } else if (std::holds_alternative<Reject>(*message)) {
      const std::uint16_t to = receiver_of(*message).value;
      const auto last = robot.rejected.find(to);
      if (last != robot.rejected.end() && now - last->second < std::chrono::seconds{1}) {
        breach(id, "rejects twice in a second");
      }
      robot.rejected[to] = now;
    } else if (partner) {
      breach(id, "sends a second frame, " + to_text(*message));
    } else {
      partner = receiver_of(*message);
    }
  }
  if (says_wait) {
    const bool waits = robot.presence.partner.value != 0;
    if (waits != robot.out.stand_still) breach(id, "says WAIT and does otherwise");
    if (waits && partner && *partner != robot.presence.partner) breach(id, "is paired with two");
    if (robot.presence.engagement == Engagement::kInSession) partner = robot.presence.partner;
  }
  if (robot.out.tuned != kCommonChannel &&
      (!partner || robot.out.tuned != private_channel(RobotId{id}, *partner, config_.air.channel_count))) {
    breach(id, "listens to a channel that is not its partner's");
  }
}

/// A path arrives whole and as the partner had it, only with a completed exchange; two robots do not meet
/// again too soon.
void AirWorld::check_exchanges(std::uint16_t id, Robot& robot) {
  for (const Exchange& exchange : robot.out.ended) {
    if (exchange.ended != now || exchange.began > now) breach(id, "ends an exchange at another time");
    for (const Exchange& earlier : robot.ended) {
      if (earlier.completed && earlier.partner == exchange.partner &&
          exchange.began - earlier.ended < config_.sharing.recontact_after) {
        breach(id, "meets the same partner too soon");
      }
    }
    robot.ended.push_back(exchange);
  }
  if (!robot.out.received) return;
  robot.received.push_back(*robot.out.received);
  const auto completed = std::find_if(robot.out.ended.begin(), robot.out.ended.end(),
                                      [](const Exchange& exchange) { return exchange.completed; });
  if (completed == robot.out.ended.end()) return breach(id, "receives a path without completing");
  const std::vector<Path>& known = paths_ever_[completed->partner.value];
  if (std::find(known.begin(), known.end(), *robot.out.received) == known.end()) {
    breach(id, "receives a path that its partner never had");
  }
}

bool AirWorld::is_symmetric() const {
  return std::all_of(robots_.begin(), robots_.end(), [this](const auto& entry) {
    const Wait& presence = entry.second.presence;
    if (presence.partner.value == 0) return true;
    const auto partner = robots_.find(presence.partner.value);
    return partner != robots_.end() && partner->second.presence.partner.value == entry.first;
  });
}

}  // namespace caravan::agent::testing
