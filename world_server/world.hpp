// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "world_server/config/world_config.hpp"
#include "world_server/types.hpp"

namespace caravan::world {

/// The emulated world of one session: bodies, sensors, items. Robots are numbered 1 .. config.robots.count.
///
/// One step: read `senses`, then `advance` with a command for each robot. Deterministic: equal configurations
/// and commands give equal bits on one machine type.
class World {
 public:
  /// @throws runtime::StartError when the robots do not fit into the arena, or the physics refuses their body
  explicit World(const WorldConfig& config);
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  /// What robot `robot` senses now; one that is not in the world senses nothing. Noise is drawn once for each
  /// robot and step, so call it once for each.
  [[nodiscard]] Senses sense(std::uint32_t robot);
  /// True poses by robot, [0] is robot 1; NaN of one that is not in the world.
  [[nodiscard]] std::span<const Pose> poses() const;

  /// Grippers act at the present poses, then physics runs for one step.
  /// @param commands [0] is robot 1; none: wheels stopped, gripper as it was
  /// @throws PhysicsError when the physics cannot go on; afterwards this world is of no use
  void advance(std::span<const std::optional<Command>> commands);

  /// Puts a robot somewhere else, at rest, with what it holds; it senses the new place at once.
  /// @return why it cannot be there, empty when it is done
  [[nodiscard]] std::string place(std::uint32_t robot, const Pose& pose);
  /// Takes a robot out of the world; what it holds goes back to the source. The last one stays: a world
  /// without robots takes no step.
  /// @return why it stays, empty when it is done
  [[nodiscard]] std::string remove(std::uint32_t robot);
  /// Puts a robot that was taken out back in, at rest and with an open gripper.
  /// @return why it cannot be there, empty when it is done
  [[nodiscard]] std::string spawn(std::uint32_t robot, const Pose& pose);
  [[nodiscard]] bool is_present(std::uint32_t robot) const;

  [[nodiscard]] std::uint64_t step() const;                        ///< steps taken so far
  [[nodiscard]] Time now() const;                                  ///< step() * period
  [[nodiscard]] std::span<const ContactEpisode> contacts() const;  ///< that began in the last step
  [[nodiscard]] std::span<const ItemEvent> item_events() const;    ///< of the last step
  /// What the physics complained of in the last step, without being in need to end (Dynamics::complaint).
  [[nodiscard]] const std::string& complaint() const;
  [[nodiscard]] std::uint32_t items_delivered() const;
  [[nodiscard]] std::uint64_t empty_closings() const;  ///< gripper closings that held nothing
  [[nodiscard]] bool finished() const;                 ///< all items delivered, or the time is over
  /// Hash over the commands and poses of every step taken.
  [[nodiscard]] std::uint64_t chain() const;
  /// What the last step, and robots placed or taken out before it, added to the chain, as docs/digest.md
  /// orders it. To be read between an advance() and what follows it.
  [[nodiscard]] std::span<const std::uint8_t> chain_link() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace caravan::world
