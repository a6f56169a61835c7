// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "runtime/host/domain_lock.hpp"
#include "runtime/host/shared_memory.hpp"
#include "tests/system/support/bus_player.hpp"

namespace caravan::test {

/// A scenario: `robots` robots in an empty room of 8 x 8 m, free pacing, source and destination 3.8 m apart.
[[nodiscard]] std::string room(std::uint32_t robots, std::uint32_t items);

/// A domain of its own for each test, and programs in it: a world, emulated Pioneers, bridges, agents.
class Field : public ::testing::Test {
 protected:
  /// Starts a program as a user would. It ends when the returned process is destroyed.
  [[nodiscard]] std::unique_ptr<Process> start(const std::string& program,
                                               std::vector<std::string> options) const;
  /// @param bodies  as for --bodies
  [[nodiscard]] std::unique_ptr<Process> start_world(const std::string& scenario_text,
                                                     const std::string& bodies);
  /// An emulated Pioneer and its ports.
  struct Robot {
    std::unique_ptr<Process> process;
    std::uint16_t port = 0;
    std::uint16_t gps_port = 0;
  };
  /// @param again  the robot that was killed; the new one gets its ports
  [[nodiscard]] Robot start_robot(std::uint32_t number, const Robot* again = nullptr) const;

  [[nodiscard]] std::unique_ptr<Process> start_agent(std::uint32_t number) const;
  /// An emulated Pioneer with its bridge, connected by TCP, and its agent.
  struct BridgedRobot {
    Robot robot;
    std::unique_ptr<Process> bridge;
    std::unique_ptr<Process> agent;
    [[nodiscard]] std::string output() const {
      return robot.process->output() + bridge->output() + agent->output();
    }
  };
  [[nodiscard]] BridgedRobot start_bridged(std::uint32_t number) const;

  /// Kills with SIGKILL. The files that the process leaves in shared memory are removed at the end of the
  /// test.
  void kill_at_once(Process& process);

  [[nodiscard]] std::filesystem::path scenario_file() const { return folder_ / "field.toml"; }
  [[nodiscard]] runtime::BusConfig bus() const {
    return {.role = "test", .domain = lock_.domain(), .lease_s = short_lease_s()};
  }

  runtime::DomainLock lock_{std::nullopt};
  ScratchFolder folder_;

 private:
  runtime::SharedMemory leftovers_{lock_.domain()};
  mutable int started_ = 0;
};

/// The poses that the world publishes.
class Truth {
 public:
  explicit Truth(const runtime::BusConfig& bus) : truths_{bus, idl::kTruth} {}
  /// Waits for the first sample. @return false if none comes
  [[nodiscard]] bool is_there() const {
    return truths_.first([](const caravan_interfaces::msg::WorldTruth&) { return true; }).has_value();
  }
  /// Simulated time of the newest sample.
  [[nodiscard]] std::chrono::nanoseconds now() const;
  /// Simulated time from `since` until the robot last moved.
  [[nodiscard]] std::chrono::nanoseconds rest_after(std::uint32_t robot,
                                                    std::chrono::nanoseconds since) const;
  [[nodiscard]] bool drives(std::uint32_t robot) const {
    return eventually([&] { return moved_m(robot, std::chrono::seconds{1}).value_or(0.0) > 0.05; },
                      kPatience);
  }
  [[nodiscard]] bool rests(std::uint32_t robot) const {
    return eventually([&] { return moved_m(robot, std::chrono::seconds{1}).value_or(1.0) < 1e-3; },
                      kPatience);
  }
  [[nodiscard]] std::optional<caravan_interfaces::msg::RobotTruth> of(std::uint32_t robot) const;
  [[nodiscard]] std::uint32_t items_delivered() const;
  /// Distance between the positions now and `span` of simulated time ago; none while the run is shorter.
  [[nodiscard]] std::optional<double> moved_m(std::uint32_t robot, std::chrono::nanoseconds span) const;

 private:
  Collector<caravan_interfaces::msg::WorldTruthPubSubType> truths_;
};

}  // namespace caravan::test
