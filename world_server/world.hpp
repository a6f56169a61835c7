// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/types.hpp>
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
/// One step: read `sense`, then `advance` with a command for each robot. Deterministic: equal configurations
/// and commands give equal bits on one machine type.
class World {
 public:
  /// @throws runtime::StartError when the robots do not fit into the arena, or the physics refuses their body
  explicit World(const WorldConfig& config);
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  /// Sensor readings of `robot` now; a robot that is not in the world senses nothing. Noise is drawn at each
  /// call, so call it exactly once per robot and step.
  [[nodiscard]] Sensors sense(std::uint32_t robot);
  /// True poses by robot, [0] is robot 1; NaN for a robot that is not in the world.
  [[nodiscard]] std::span<const Pose> poses() const;

  /// Executes grippers at the present poses, then physics for one step.
  /// @param commands [0] is robot 1; none: wheels stop, gripper keeps its state
  /// @throws PhysicsError when the physics cannot continue; this world is then unusable
  void advance(std::span<const std::optional<Command>> commands);

  /// Moves a robot to another pose, at rest, with its item; it senses the new place at once.
  /// @return why it cannot be there; empty on success
  [[nodiscard]] std::string place(std::uint32_t robot, const Pose& pose);
  /// Removes a robot from the world; its item returns to the source. The last robot stays: a world without
  /// robots takes no step.
  /// @return why it stays; empty on success
  [[nodiscard]] std::string remove(std::uint32_t robot);
  /// Puts a removed robot back, at rest and with an open gripper.
  /// @return why it cannot be there; empty on success
  [[nodiscard]] std::string spawn(std::uint32_t robot, const Pose& pose);
  [[nodiscard]] bool is_present(std::uint32_t robot) const;

  [[nodiscard]] std::uint64_t step() const;                        ///< steps taken so far
  [[nodiscard]] Time now() const;                                  ///< step() * period
  [[nodiscard]] std::span<const ContactEpisode> contacts() const;  ///< episodes that began in the last step
  [[nodiscard]] std::span<const ItemEvent> item_events() const;    ///< of the last step
  /// Warning of the physics in the last step that did not end the run (Dynamics::complaint).
  [[nodiscard]] const std::string& complaint() const;
  [[nodiscard]] std::uint32_t items_delivered() const;
  [[nodiscard]] std::uint64_t empty_closings() const;  ///< gripper closings that held nothing
  [[nodiscard]] bool finished() const;                 ///< all items delivered, or time over
  /// Hash over the commands and poses of every step taken.
  [[nodiscard]] std::uint64_t chain() const;
  /// Data that the last step, and robots placed or removed before it, added to the chain, in the order of
  /// docs/digest.md. Read it between an advance() and the next call.
  [[nodiscard]] std::span<const std::uint8_t> chain_link() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace caravan::world
