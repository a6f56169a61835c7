// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robot_agent/core/radio/communication.hpp"
#include "robot_agent/core/radio/frames/messages.hpp"
#include "runtime/pure/random.hpp"

namespace caravan::agent::testing {

/// The effects of the radio medium on each frame on its way to each receiver.
struct Weather {
  double loss = 0.0;
  double duplicate = 0.0;
  int max_delay_steps = 0;  ///< in addition to the one step of every frame
};

/// Robots in simulated time, all within radio range unless parted. After each step it checks the invariants
/// that hold whatever the medium does, and records violations in `breaches`.
class AirWorld {
 public:
  struct Robot {
    CommunicationSettings config;
    Communication communication;
    Path path;
    AirOutputs out;
    Wait presence;         // its last WAIT
    Time still_since{-1};  // -1: it is driving
    Time longest_still{0};
    Time stood{0};  // total
    std::vector<Exchange> ended;
    std::vector<Path> received;
    std::map<std::uint16_t, Time> rejected;  // time of the last rejection of each robot
  };

  AirWorld(std::uint64_t seed, const CommunicationSettings& config);
  void add(std::uint16_t id, Path path);
  void remove(std::uint16_t id);
  void restart(std::uint16_t id);
  /// Sets whether two robots are out of range of each other from now on.
  void part(std::uint16_t one, std::uint16_t other, bool parted);
  void run(int steps);
  void run_for(Time span) { run(static_cast<int>(span / kStep)); }

  [[nodiscard]] Robot& robot(std::uint16_t id) { return robots_.at(id); }
  [[nodiscard]] std::map<std::uint16_t, Robot>& robots() { return robots_; }
  /// True if each robot that waits for a partner has a partner that waits for it.
  [[nodiscard]] bool is_symmetric() const;

  static constexpr Time kStep = std::chrono::milliseconds{32};
  Weather weather;
  Time now;
  std::vector<std::string> breaches;

 private:
  struct Flying {
    std::uint16_t to;
    Time arrives;
    Frame frame;
  };
  void fly();
  void check(std::uint16_t id, Robot& robot);
  void check_frames(std::uint16_t id, Robot& robot);
  void check_exchanges(std::uint16_t id, Robot& robot);
  void breach(std::uint16_t id, const std::string& what);
  [[nodiscard]] bool are_parted(std::uint16_t one, std::uint16_t other) const;

  CommunicationSettings config_;
  pure::Random random_;
  std::map<std::uint16_t, Robot> robots_;
  std::map<std::uint16_t, std::vector<Path>> paths_ever_;
  std::vector<Flying> flying_;
  std::map<std::pair<std::uint16_t, std::uint16_t>, bool> parted_;
};

/// A path with this number of points, different for each robot.
[[nodiscard]] Path path_of(std::uint16_t id, std::size_t points);

}  // namespace caravan::agent::testing
