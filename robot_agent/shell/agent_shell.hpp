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

/// The bus interface of one process's agents: one, or several that share no information. Each agent has five
/// topics: sensors and radio/rx in, command, radio/tx and telemetry out.
///
/// Agents step on the bus's receiving thread, each when its own sensor frame arrives. The main thread checks
/// the deadlines, and resolves a clash with another process that runs one of these robots: the process that
/// has to yield gives up all of its robots.
class AgentShell {
 public:
  /// @param configs  one for each robot, at least one, no robot twice
  AgentShell(const Controllers& controllers, const std::vector<Config>& configs,
             const runtime::BusConfig& bus, runtime::Loop& loop);
  ~AgentShell();
  AgentShell(const AgentShell&) = delete;
  AgentShell& operator=(const AgentShell&) = delete;

  /// Runs until the loop stops or a controller fails; then sets the wheels of its robots to zero. Ends the
  /// process if a step of a controller does not return.
  /// @return the exit code
  /// @throws StartError when another process holds one of the robots; BeginAnew after a suspension for longer
  /// than the lease
  int run();

 private:
  using Wall = std::chrono::steady_clock::time_point;

  /// An agent, and the participants whose samples it accepts.
  struct Hosted {
    Hosted(const Controllers& controllers, const Config& config, runtime::Bus& bus, runtime::Calls& calls)
        : agent{controllers, config, bus, calls} {}
    HostedAgent agent;
    runtime::Tenure provider;  // sends sensor frames: the world or a bridge
    runtime::Tenure radio;
  };

  void make_readers(Hosted& one);
  void hear(Hosted& one, const caravan_interfaces::msg::RadioReceive& sample, const runtime::Sender& sender);
  void sense(Hosted& one, const caravan_interfaces::msg::SensorFrame& frame, const runtime::Sender& sender);
  /// Takes the lock. Warns while a controller's step holds it; if the process is to stop, ends it then.
  [[nodiscard]] std::unique_lock<std::timed_mutex> lock_or_end(bool is_stopping);
  /// Ends the process, because a controller does not return.
  [[noreturn]] void end_process(runtime::CallWatch::Reason reason) const;
  /// The one whose controller is called at present; null: none.
  [[nodiscard]] const HostedAgent* called_agent() const;
  [[nodiscard]] bool has_failed() const;
  void halt_all();
  void watch(Wall now);
  void read_mailbox(Wall now);
  void meet(const runtime::Discovery& writer, Wall now);
  /// Handles a participant, or one of its writers, that has gone. Either counts as leaving.
  void forget(const runtime::Discovery& gone);
  /// The next participant that has claimed the role becomes its holder.
  void hand_over(runtime::Tenure& tenure);
  /// @throws StartError when the other process remains
  void settle_clash(Wall now);
  void say_who_waits(Wall now);
  /// None: every agent has received from its world.
  [[nodiscard]] const HostedAgent* first_without_world() const;
  [[nodiscard]] Wall next_deadline(Wall now) const;

  runtime::Loop& loop_;
  const double lease_s_;
  const Wall began_;

  const Controllers& controllers_;

  std::timed_mutex mutex_;
  runtime::Calls calls_;                                 // under the lock, so one at a time
  std::deque<Hosted> agents_;                            // callbacks refer to its elements
  std::map<std::string, std::uint32_t> robot_of_topic_;  // topics of these robots' commands
  std::optional<runtime::Clash> clash_;
  std::optional<Wall> said_waiting_;
  bool told_refused_writes_ = false;

  runtime::Mailbox<runtime::Discovery> mailbox_{loop_};

  runtime::Bus bus_;  // so late that no callback outlives the state
  std::optional<runtime::CallWatch> watch_;
};

}  // namespace caravan::agent
