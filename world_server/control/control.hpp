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

/// What may be asked of a running world.
struct Pause {};
struct Resume {};
struct TakeSteps {
  std::uint32_t count = 1;
};
struct SetSpeed {
  double factor = 1.0;  ///< simulated by real time; 0: as fast as possible
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
/// Puts a robot that was removed back into the world.
struct Spawn {
  std::uint32_t robot = 0;
  Pose at;
};
/// Takes a robot out of the world, and ends hold.
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

/// Runtime control of the world: which orders are taken, and what they do when their step comes. Knows no
/// topic and no clock.
///
/// Everything takes effect between two steps, before the sensors of the second are published. So a run that
/// is controlled by orders for given steps repeats itself bit for bit.
class Control {
 public:
  /// Of SetSpeed.
  static constexpr double kSlowest = 0.001;
  static constexpr double kFastest = 1000.0;

  /// What the world does to robots when it is told to. Each says why it cannot be done, or nothing.
  struct Hands {
    std::function<std::string(const Teleport&)> teleport;
    std::function<std::string(const Spawn&)> spawn;
    std::function<std::string(const Remove&)> remove;
  };

  explicit Control(const ControlConfig& config);

  /// An order has come.
  /// @param next_step  the first step that has not begun
  /// @return none when it is a repetition
  [[nodiscard]] std::optional<Outcome> ask(Order order, std::uint64_t next_step);
  /// Step `step` may begin now. Called again while the world is held before it.
  /// @return what became of the orders that were due
  [[nodiscard]] std::vector<Outcome> reach(std::uint64_t step, const Hands& hands);
  /// The run is over: nothing is obeyed any more.
  [[nodiscard]] std::vector<Outcome> end();

  [[nodiscard]] bool is_paused() const { return paused_; }
  [[nodiscard]] double speed() const { return speed_; }
  [[nodiscard]] bool is_held(std::uint32_t robot) const { return held_[robot - 1]; }
  /// Whether any order has taken effect.
  [[nodiscard]] bool was_used() const { return used_; }

 private:
  [[nodiscard]] std::string refusal_of(const Action& action) const;
  /// @return why not, empty when it is done
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
