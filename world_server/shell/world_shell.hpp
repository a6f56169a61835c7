// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "idl/clock_types.hpp"
#include "idl/control_types.hpp"
#include "idl/robot_types.hpp"
#include "idl/world_types.hpp"
#include "runtime/bus/bus.hpp"
#include "runtime/bus/tenure.hpp"
#include "runtime/process/loop.hpp"
#include "runtime/process/mailbox.hpp"
#include "runtime/trace/trace_file.hpp"
#include "world_server/barrier/barrier.hpp"
#include "world_server/control/control.hpp"
#include "world_server/shell/credits.hpp"
#include "world_server/shell/tallies.hpp"
#include "world_server/world.hpp"

namespace caravan::world {

/// Free pacing: how long a command holds.
inline constexpr Time kDeadman = std::chrono::milliseconds{600};

/// The world on the bus: publishes what robots sense, moves the world when their commands are in, and holds
/// the lockstep.
///
/// Steps run on the bus's receiving thread, where the last sample that a step needs arrives. The main thread
/// keeps the deadlines (pacing, hung processes, status). Discovery leaves its news in a mailbox that either
/// of the two empties.
class WorldShell {
 public:
  /// @param awaited observers (by the name in their credit) without which the run does not start
  /// @param trace   receives what each step adds to the world's hash chain; null: nobody does
  WorldShell(const WorldConfig& config, const runtime::BusConfig& bus,
             const std::vector<std::string>& awaited, std::unique_ptr<runtime::TraceFile> trace,
             runtime::Loop& loop);
  ~WorldShell();
  WorldShell(const WorldShell&) = delete;
  WorldShell& operator=(const WorldShell&) = delete;

  /// Until the loop is told to stop. @return the exit code
  int run();

 private:
  enum class Phase : std::uint8_t { kWaiting, kOpen, kAdvanced, kClosed, kFinished, kFailed };

  // What arrives.
  void on_command(std::uint32_t robot, const caravan_interfaces::msg::RobotCommand& sample,
                  const runtime::Sender& sender);
  void take_command(std::uint32_t robot, const caravan_interfaces::msg::RobotCommand& sample);
  void take_radio_step(const caravan_interfaces::msg::RadioStep& sample);
  void on_radio_step(const caravan_interfaces::msg::RadioStep& sample, const runtime::Sender& sender);
  void on_credit(const caravan_interfaces::msg::RunCredit& sample, const runtime::Sender& sender);
  void on_control(const caravan_interfaces::msg::ControlRequest& request);
  [[nodiscard]] bool is_current(std::uint64_t session, Time stamp) const;
  [[nodiscard]] const idl::Topic& command_topic(std::uint32_t robot) const;

  // The step. All of these run under the lock.
  void read_mailbox();
  void meet(const runtime::Discovery& writer);
  /// A participant has gone, or one of its writers: leaving is either.
  void forget(const runtime::Discovery& gone);
  /// @return true when a member left the step
  bool forget_agent(std::uint32_t robot, const runtime::Discovery& gone);
  void forget_radio(const runtime::Discovery& gone);
  /// The next participant that has claimed the role holds it.
  void hand_over(runtime::Tenure& tenure);
  void progress();
  void reach_boundary();
  [[nodiscard]] std::string spawn(const Spawn& spawn);
  [[nodiscard]] std::string remove(const Remove& remove);
  void reply(const std::vector<Outcome>& outcomes);
  [[nodiscard]] std::uint64_t next_step() const;
  [[nodiscard]] bool is_disturbed() const;
  [[nodiscard]] bool may_open(Wall now);
  void open_step();
  void publish_sensors();
  void publish_truth(bool last);
  void advance();
  void finish();
  /// The physics cannot go on.
  void fail(const std::string& reason);

  // The main thread.
  void watch(Wall now);
  void free_step();
  void publish_status(Wall now);
  void name_the_late(Wall now);
  [[nodiscard]] Wall next_deadline(Wall now) const;
  [[nodiscard]] std::vector<std::string> missing() const;
  [[nodiscard]] std::vector<std::uint32_t> removed() const;

  WorldConfig config_;
  runtime::Loop& loop_;
  const double lease_s_;
  const std::uint64_t session_;
  const Time period_;
  const std::unique_ptr<runtime::TraceFile> trace_;

  std::mutex mutex_;
  World world_;
  Barrier barrier_;
  Control control_;
  Credits credits_;
  Tallies tallies_;
  Phase phase_ = Phase::kWaiting;
  Time stamp_{0};  // of the open step
  std::vector<std::optional<Command>> commands_;
  std::vector<Time> commanded_at_;
  std::vector<std::uint32_t> reporting_;  // robots that have reported in the open step
  std::vector<runtime::Tenure> drivers_;  // who commands each robot
  runtime::Tenure radio_;
  std::vector<std::vector<runtime::Sender>> agents_;  // that live, by robot: the first one found first
  std::vector<bool> radio_due_;
  std::uint64_t radio_chain_;
  bool radio_controlled_ = false;
  Wall due_{};           // of the next step, when paced
  Wall notified_due_{};  // the main thread has been woken to wait for this
  Wall status_due_{};
  std::string digest_;
  std::string failure_;  // why the phase is kFailed
  std::vector<std::uint32_t> named_hung_;
  std::optional<std::string> held_by_;  // an observer that has not handled enough
  Wall held_since_{};
  bool named_hold_ = false;
  bool told_refused_writes_ = false;

  runtime::Mailbox<runtime::Discovery> mailbox_{loop_};

  caravan_interfaces::msg::SensorFrame frame_;
  caravan_interfaces::msg::WorldTruth truth_;
  runtime::Bus bus_;  // after the state, so that no callback outlives it
  std::vector<runtime::Writer<caravan_interfaces::msg::SensorFramePubSubType>> sensors_;
  runtime::Writer<caravan_interfaces::msg::WorldTruthPubSubType> truths_;
  runtime::Writer<rosgraph_msgs::msg::ClockPubSubType> clock_;
  runtime::Writer<caravan_interfaces::msg::WorldStatusPubSubType> statuses_;
  runtime::Writer<caravan_interfaces::msg::ControlReplyPubSubType> replies_;
};

}  // namespace caravan::world
