// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "runtime/process/loop.hpp"
#include "runtime/process/mailbox.hpp"
#include "runtime/trace/trace_file.hpp"
#include "world_server/barrier/lockstep.hpp"
#include "world_server/barrier/pace.hpp"
#include "world_server/barrier/step_inputs.hpp"
#include "world_server/shell/credits.hpp"
#include "world_server/shell/outputs.hpp"

namespace caravan::world {

/// The world on the bus: publishes the robots' sensor readings, moves the world when it has their commands,
/// and keeps the lockstep.
///
/// Steps run on the bus's receiving thread, where the last sample that a step needs arrives. The main thread
/// watches the deadlines (pacing, hung processes, status). Discovery posts to a mailbox that either of the
/// two reads.
class WorldShell {
 public:
  /// @param awaited observers (by the name in their credit) without which the run does not start
  /// @param trace   records what each step adds to the world's hash chain; null: no trace
  WorldShell(const WorldConfig& config, const runtime::BusConfig& bus,
             const std::vector<std::string>& awaited, std::unique_ptr<runtime::TraceFile> trace,
             runtime::Loop& loop);
  ~WorldShell();
  WorldShell(const WorldShell&) = delete;
  WorldShell& operator=(const WorldShell&) = delete;

  /// Runs until the loop is stopped. @return the exit code
  int run();

 private:
  /// The sender of a robot's commands, and the agents that discovery has found, the first one first.
  struct Driver {
    runtime::Tenure tenure;
    std::vector<runtime::Sender> agents;
  };
  /// Conditions that have been logged and are not logged again until they change.
  struct Logged {
    std::vector<std::uint32_t> hung;
    bool hold = false;
    bool refused_writes = false;
  };

  // arrivals.cpp, on the receiving thread. take_*: under the lock.
  void on_command(std::uint32_t robot, const caravan_interfaces::msg::RobotCommand& sample,
                  const runtime::Sender& sender);
  void take_command(std::uint32_t robot, const caravan_interfaces::msg::RobotCommand& sample);
  void on_radio_step(const caravan_interfaces::msg::RadioStep& sample, const runtime::Sender& sender);
  void take_radio_step(const caravan_interfaces::msg::RadioStep& sample);
  void on_credit(const caravan_interfaces::msg::RunCredit& sample, const runtime::Sender& sender);

  // members.cpp, under the lock.
  void read_mailbox();
  void meet(const runtime::Discovery& writer);
  /// Handles the loss of a participant or of one of its writers; either counts as leaving.
  void forget(const runtime::Discovery& gone);
  /// @return true when a member left the step
  bool forget_agent(std::uint32_t robot, const runtime::Discovery& gone);
  void forget_radio(const runtime::Discovery& gone);
  /// Gives the role to the next participant that has claimed it.
  void hand_over(runtime::Tenure& tenure);
  [[nodiscard]] const idl::Topic& command_topic(std::uint32_t robot) const;

  // control.cpp. All but on_control() under the lock.
  void on_control(const caravan_interfaces::msg::ControlRequest& request);
  /// Between two steps: executes the orders that are due.
  void reach_boundary();
  [[nodiscard]] std::string spawn(const Spawn& spawn);
  [[nodiscard]] std::string remove(const Remove& remove);
  /// Lets the main thread publish the status at once.
  void status_changed();

  // step.cpp, under the lock.
  void progress();
  [[nodiscard]] bool may_open(Wall now);
  void open_step();
  void advance();
  void finish();
  void publish_sensors();
  void publish_truth();

  // watch.cpp and status.cpp, on the main thread. All but run() under the lock.
  void watch(Wall now);
  void free_step();
  [[nodiscard]] Wall next_deadline(Wall now) const;
  [[nodiscard]] std::vector<std::string> missing() const;
  void name_the_late(Wall now);
  /// Beside robots, radio and a pause: why the next step has not opened for some time. Empty: it need not
  /// wait.
  [[nodiscard]] std::string held(Wall now) const;
  void publish_status(Wall now);

  const WorldConfig config_;
  const bool follows_clock_;  // pacing `free`
  runtime::Loop& loop_;
  const double lease_s_;
  const std::uint64_t session_;
  const Time period_;
  const std::unique_ptr<runtime::TraceFile> trace_;

  std::mutex mutex_;
  World world_;
  Barrier barrier_;
  Lockstep lockstep_;
  StepInputs inputs_;
  Pace pace_;
  Control control_;
  Credits credits_;
  HeldBack hold_;
  std::vector<Driver> drivers_;  // [0] is robot 1
  runtime::Tenure radio_;
  Tallies tallies_;
  Logged logged_;
  Wall status_due_{};
  Wall woken_for_{};  // the main thread has been woken to wait for this due step
  std::string digest_;
  std::string failure_;  // why the phase is kFailed

  runtime::Mailbox<runtime::Discovery> mailbox_{loop_};
  runtime::Bus bus_;  // after the state, so that no callback outlives it
  Outputs outputs_;
};

}  // namespace caravan::world
