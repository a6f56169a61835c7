// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "runtime/pure/agenda.hpp"
#include "world_server/types.hpp"

namespace caravan::world {

/// Requests to a running world.
struct Pause {};
struct Resume {};
struct TakeSteps {
  std::uint32_t count = 1;
};
struct SetSpeed {
  double factor = 1.0;  ///< simulated time divided by real time; 0: as fast as possible
};
struct Teleport {
  std::uint32_t robot = 0;
  Pose to;
};
/// Blocks a robot's wheels, whatever it commands.
struct Hold {
  std::uint32_t robot = 0;
};
struct Release {
  std::uint32_t robot = 0;
};
/// Puts a removed robot back into the world.
struct Spawn {
  std::uint32_t robot = 0;
  Pose at;
};
/// Removes a robot from the world, and ends Hold.
struct Remove {
  std::uint32_t robot = 0;
};
struct UnknownAction {};
using Action =
    std::variant<Pause, Resume, TakeSteps, SetSpeed, Teleport, Hold, Release, Spawn, Remove, UnknownAction>;
using Order = pure::Order<Action>;
using pure::Outcome;

struct ControlConfig {
  std::uint32_t robots = 1;
  double speed = 0.0;          ///< at the start, as in SetSpeed
  bool follows_clock = false;  ///< pacing `free`: its speed is that of the clock
};

/// Runtime control of the world: which orders are accepted, and their effect at their step. Has no topics and
/// no clock.
///
/// Orders take effect between two steps, before the sensors of the second are published. A run controlled by
/// orders for given steps is therefore repeatable bit for bit.
class Control {
 public:
  /// Limits of SetSpeed.
  static constexpr double kSlowest = 0.001;
  static constexpr double kFastest = 1000.0;

  /// The world's operations on robots. Each returns why it cannot be done; empty on success.
  struct Hands {
    std::function<std::string(const Teleport&)> teleport;
    std::function<std::string(const Spawn&)> spawn;
    std::function<std::string(const Remove&)> remove;
  };

  explicit Control(const ControlConfig& config);

  /// Handles the arrival of an order.
  /// @param next_step  the first step that has not begun
  /// @return none if the order is a repetition
  [[nodiscard]] std::optional<Outcome> ask(Order order, std::uint64_t next_step);
  /// Executes the orders for `step`, which may begin now. Called again while the world is paused before it.
  /// @return the outcomes of the orders that were due
  [[nodiscard]] std::vector<Outcome> reach(std::uint64_t step, const Hands& hands);
  /// The run is over: refuses all further orders.
  [[nodiscard]] std::vector<Outcome> end();

  [[nodiscard]] bool is_paused() const { return paused_; }
  [[nodiscard]] double speed() const { return speed_; }
  [[nodiscard]] bool is_held(std::uint32_t robot) const { return held_[robot - 1]; }
  /// Whether any order has taken effect.
  [[nodiscard]] bool was_used() const { return used_; }

 private:
  [[nodiscard]] std::string refusal_of(const Action& action) const;
  /// @return why not; empty on success
  [[nodiscard]] std::string obey(const Action& action, std::uint64_t step, const Hands& hands);

  ControlConfig config_;
  pure::Agenda<Action> agenda_;
  std::vector<bool> held_;  // [0] is robot 1
  bool paused_ = false;
  std::optional<std::uint64_t> pause_at_;  // while the steps of a TakeSteps are taken
  double speed_;
  bool used_ = false;
  bool ended_ = false;
};

}  // namespace caravan::world
