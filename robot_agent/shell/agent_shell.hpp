// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "robot_agent/shell/hosted_agent.hpp"
#include "runtime/bus/bus.hpp"
#include "runtime/bus/clash.hpp"
#include "runtime/bus/tenure.hpp"
#include "runtime/process/loop.hpp"
#include "runtime/process/mailbox.hpp"

namespace caravan::agent {

/// The agents of one process on the bus: one, or several that know nothing of each other. Five topics are all
/// that each has: sensors and radio/rx in, command, radio/tx and telemetry out.
///
/// They step on the bus's receiving thread, each when its own sensor frame arrives. The main thread keeps the
/// deadlines, and settles a clash with another process that runs one of these robots: whoever must give way
/// gives way with all of its robots.
class AgentShell {
 public:
  /// @param configs one for each robot, at least one, no robot twice
  AgentShell(const Controllers& controllers, const std::vector<Config>& configs,
             const runtime::BusConfig& bus, runtime::Loop& loop);
  ~AgentShell();
  AgentShell(const AgentShell&) = delete;
  AgentShell& operator=(const AgentShell&) = delete;

  /// Until the loop is told to stop, or a controller fails; then leaves the robots with their wheels at zero.
  /// A step that does not return ends the process from here. @return the exit code
  /// @throws StartError when another process holds one of the robots
  int run();

 private:
  using Wall = std::chrono::steady_clock::time_point;

  /// One of the agents, and who may speak to it.
  struct Hosted {
    Hosted(const Controllers& controllers, const Config& config, runtime::Bus& bus)
        : agent{controllers, config, bus} {}
    HostedAgent agent;
    runtime::Tenure provider;  // of sensor frames: the world or a bridge
    runtime::Tenure radio;
  };

  void make_readers(Hosted& one);
  void hear(Hosted& one, const caravan_interfaces::msg::RadioReceive& sample, const runtime::Sender& sender);
  void sense(Hosted& one, const caravan_interfaces::msg::SensorFrame& frame, const runtime::Sender& sender);
  /// Takes the lock. While a controller keeps it in a step, says so and at last ends the process.
  [[nodiscard]] std::unique_lock<std::timed_mutex> lock_or_end();
  /// A controller has failed.
  [[nodiscard]] bool has_failed() const;
  void halt_all();
  void watch(Wall now);
  void read_mailbox(Wall now);
  void meet(const runtime::Discovery& writer, Wall now);
  /// A participant has gone, or one of its writers: leaving is either.
  void forget(const runtime::Discovery& gone);
  /// The next participant that has claimed the role holds it.
  void hand_over(runtime::Tenure& tenure);
  /// @throws StartError when the other process does not vanish
  void settle_clash(Wall now);
  void say_who_waits(Wall now);
  /// None: every agent has heard from its world.
  [[nodiscard]] const HostedAgent* first_without_world() const;
  [[nodiscard]] Wall next_deadline(Wall now) const;

  runtime::Loop& loop_;
  const double lease_s_;
  const Wall began_;

  const Controllers& controllers_;

  std::timed_mutex mutex_;
  std::deque<Hosted> agents_;                            // callbacks refer to them
  std::map<std::string, std::uint32_t> robot_of_topic_;  // commands of these robots are ours to write
  std::optional<runtime::Clash> clash_;
  std::optional<Wall> said_waiting_;
  bool told_refused_writes_ = false;

  runtime::Mailbox<runtime::Discovery> mailbox_{loop_};

  runtime::Bus bus_;  // after the state, so that no callback outlives it
};

}  // namespace caravan::agent
