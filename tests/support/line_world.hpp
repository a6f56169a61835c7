// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "robot_agent/core/agent.hpp"
#include "tests/support/sonar_model.hpp"

namespace caravan::test {

/// A body in the line world: a disc that looks like a square to the sonars.
struct Body {
  agent::Point p_WB{0.0, 0.0};
  double yaw_WB_rad = 0.0;
  bool holding = false;
  bool alive = true;  ///< a dead one stands still and sends nothing
};

/// A flat world of line segments in which whole agents drive without physics: wheels follow commands at once,
/// bodies stop at walls and at each other. Sonars lose rays at more than 22.5 degrees, as in the emulated
/// world.
class LineWorld {
 public:
  explicit LineWorld(agent::Config config) : config_{std::move(config)} {}

  void add_walls(const std::vector<Wall>& walls) { walls_.insert(walls_.end(), walls.begin(), walls.end()); }
  /// A robot with an agent; ids count from 1.
  void add_robot(const agent::Point& p_WB, double yaw_WB_rad);
  /// A body of a robot's size that sends nothing.
  void add_dead(const agent::Point& p_WB);
  void step();
  void run_for(double seconds);

  [[nodiscard]] agent::Sensors sense(std::size_t robot) const;
  [[nodiscard]] const Body& body(std::size_t robot) const { return bodies_[robot]; }
  [[nodiscard]] const agent::Outputs& outputs(std::size_t robot) const { return outputs_[robot]; }
  [[nodiscard]] std::uint32_t delivered(std::size_t robot) const { return delivered_[robot]; }
  [[nodiscard]] const std::vector<agent::Point>& path(std::size_t robot) const { return paths_[robot]; }
  [[nodiscard]] int count(std::size_t robot, const std::string& event) const;
  [[nodiscard]] double now_s() const { return static_cast<double>(step_) * kStep_s; }
  void kill(std::size_t robot) { bodies_[robot].alive = false; }
  /// Number of contacts between live robots, as rectangles; a pair that stays together counts once.
  [[nodiscard]] int contacts() const { return contacts_; }
  /// Number of steps in which a wall or another body stopped a body.
  [[nodiscard]] std::uint64_t held() const { return held_; }
  [[nodiscard]] double longest_stand_s() const { return longest_stand_s_; }

 private:
  static constexpr double kStep_s = 0.032;
  [[nodiscard]] bool is_free(std::size_t robot, const agent::Point& p_WB) const;
  void move(std::size_t robot, const agent::Wheels& wheels);
  void grip(std::size_t robot, bool closed);
  void deliver_frames();
  void count_contacts();

  agent::Config config_;
  std::vector<Wall> walls_;
  std::vector<Body> bodies_;
  std::vector<agent::Agent> agents_;  // of the first bodies
  std::vector<agent::Outputs> outputs_;
  std::vector<std::vector<agent::ReceivedFrame>> heard_;
  std::vector<std::vector<agent::Point>> paths_;
  std::vector<std::uint32_t> delivered_;
  std::vector<bool> closed_;
  std::vector<std::map<std::string, int>> events_;
  std::vector<agent::Point> stood_at_;
  std::vector<double> stood_since_;
  std::uint64_t step_ = 0;
  std::uint64_t held_ = 0;
  std::set<std::pair<std::size_t, std::size_t>> touching_;
  int contacts_ = 0;
  double longest_stand_s_ = 0.0;
};

}  // namespace caravan::test
