// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robot_agent/core/radio/communication.hpp"
#include "robot_agent/core/radio/frames/messages.hpp"
#include "runtime/pure/random.hpp"

namespace caravan::agent::testing {

/// What the air does to each frame on its way to each receiver.
struct Weather {
  double loss = 0.0;
  double duplicate = 0.0;
  int max_delay_steps = 0;  ///< beyond the one step that every frame takes
};

/// Robots in virtual time, all within earshot unless parted. After every step it checks what must hold
/// whatever the air does; what does not is in `breaches`.
class AirWorld {
 public:
  struct Robot {
    CommunicationSettings config;
    Communication communication;
    Path path;
    AirOutputs out;
    Wait presence;         // its last WAIT
    Time still_since{-1};  // -1: it drives
    Time longest_still{0};
    Time stood{0};  // in all
    std::vector<Exchange> ended;
    std::vector<Path> received;
    std::map<std::uint16_t, Time> rejected;  // when last
  };

  AirWorld(std::uint64_t seed, const CommunicationSettings& config);
  void add(std::uint16_t id, Path path);
  void remove(std::uint16_t id);
  void restart(std::uint16_t id);
  /// Whether two robots hear each other from now on.
  void part(std::uint16_t one, std::uint16_t other, bool parted);
  void run(int steps);
  void run_for(Time span) { run(static_cast<int>(span / kStep)); }

  [[nodiscard]] Robot& robot(std::uint16_t id) { return robots_.at(id); }
  [[nodiscard]] std::map<std::uint16_t, Robot>& robots() { return robots_; }
  /// True while each robot that waits for a partner is waited for by it.
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

/// A path of so many points, different for each robot.
[[nodiscard]] Path path_of(std::uint16_t id, std::size_t points);

}  // namespace caravan::agent::testing
