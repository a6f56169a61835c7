// SPDX-License-Identifier: Apache-2.0
#include "world_server/control/control.hpp"

#include <cmath>
#include <utility>

#include "runtime/pure/overload.hpp"

namespace caravan::world {
namespace {

bool is_finite(const Pose& pose) {
  return std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.yaw_rad);
}

}  // namespace

Control::Control(const ControlConfig& config)
    : config_{config}, held_(config.robots, false), speed_{config.speed} {}

std::string Control::refusal_of(const Action& action) const {
  const auto unless_known = [this](std::uint32_t robot) {
    if (robot >= 1 && robot <= config_.robots) return std::string{};
    return "there is no robot " + std::to_string(robot) + ", only 1 to " + std::to_string(config_.robots);
  };
  return std::visit(
      pure::Overload{
          [](const Pause&) { return std::string{}; }, [](const Resume&) { return std::string{}; },
          [](const TakeSteps& steps) {
            return std::string{steps.count == 0 ? "the number of steps must be at least 1" : ""};
          },
          [this](const SetSpeed& speed) {
            if (config_.follows_clock) return std::string{"pacing free follows the clock"};
            const bool fits = speed.factor == 0.0 || (speed.factor >= kSlowest && speed.factor <= kFastest);
            return std::string{fits ? "" : "the speed must be 0.001 to 1000, or 0 for as fast as possible"};
          },
          [&](const Teleport& teleport) {
            return is_finite(teleport.to) ? unless_known(teleport.robot) : "the pose must be finite";
          },
          [&](const Hold& hold) { return unless_known(hold.robot); },
          [&](const Release& release) { return unless_known(release.robot); },
          [&](const Spawn& spawn) {
            return is_finite(spawn.at) ? unless_known(spawn.robot) : "the pose must be finite";
          },
          [&](const Remove& remove) { return unless_known(remove.robot); },
          [](const UnknownAction&) { return std::string{"unknown action"}; }},
      action);
}

std::optional<Outcome> Control::ask(Order order, std::uint64_t next_step) {
  std::string refusal = ended_ ? "the run has ended" : refusal_of(order.action);
  return agenda_.add(std::move(order), next_step, std::move(refusal));
}

std::string Control::obey(const Action& action, std::uint64_t step, const Hands& hands) {
  const auto done = [] { return std::string{}; };
  return std::visit(pure::Overload{[&](const Pause&) {
                                     paused_ = true;
                                     pause_at_.reset();
                                     return done();
                                   },
                                   [&](const Resume&) {
                                     paused_ = false;
                                     pause_at_.reset();
                                     return done();
                                   },
                                   [&](const TakeSteps& steps) {
                                     if (!paused_) return std::string{"the world is running: pause it first"};
                                     paused_ = false;
                                     pause_at_ = step + steps.count;
                                     return done();
                                   },
                                   [&](const SetSpeed& speed) {
                                     speed_ = speed.factor;
                                     return done();
                                   },
                                   [&](const Teleport& teleport) { return hands.teleport(teleport); },
                                   [&](const Spawn& spawn) { return hands.spawn(spawn); },
                                   [&](const Remove& remove) {
                                     std::string refusal = hands.remove(remove);
                                     if (refusal.empty()) held_[remove.robot - 1] = false;
                                     return refusal;
                                   },
                                   [&](const Hold& hold) {
                                     held_[hold.robot - 1] = true;
                                     return done();
                                   },
                                   [&](const Release& release) {
                                     held_[release.robot - 1] = false;
                                     return done();
                                   },
                                   [&](const UnknownAction& never_taken) { return refusal_of(never_taken); }},
                    action);
}

std::vector<Outcome> Control::reach(std::uint64_t step, const Hands& hands) {
  if (pause_at_ && step >= *pause_at_) {
    paused_ = true;
    pause_at_.reset();
  }
  std::vector<Outcome> outcomes;
  for (const Order& order : agenda_.due(step)) {
    const std::string refusal = obey(order.action, step, hands);
    const bool done = refusal.empty();
    used_ = used_ || done;
    outcomes.push_back(
        {order.requester, order.id, done ? Outcome::Kind::kDone : Outcome::Kind::kRefused, step, refusal});
  }
  return outcomes;
}

std::vector<Outcome> Control::end() {
  ended_ = true;
  std::vector<Outcome> outcomes;
  for (const Order& order : agenda_.rest()) {
    outcomes.push_back({order.requester, order.id, Outcome::Kind::kRefused, order.at_step,
                        "the run ended before step " + std::to_string(order.at_step)});
  }
  return outcomes;
}

}  // namespace caravan::world
