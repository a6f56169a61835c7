// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "idl/control_types.hpp"
#include "idl/robot_types.hpp"
#include "idl/world_types.hpp"
#include "radio_emulator/medium/medium.hpp"
#include "radio_emulator/medium/radio_control.hpp"
#include "runtime/bus/bus.hpp"
#include "runtime/bus/tenure.hpp"
#include "runtime/process/loop.hpp"
#include "runtime/process/mailbox.hpp"
#include "runtime/pure/hash_chain.hpp"
#include "runtime/trace/trace_file.hpp"

namespace caravan::radio {

struct Fleet {
  std::uint32_t robots = 0;                ///< numbered from 1
  std::vector<std::uint32_t> bodies = {};  ///< robots behind a bridge, sorted
};

/// The medium on the bus: from the truth of a step and the transmissions of its members, computes the
/// receptions.
///
/// Runs on the bus's receiving thread; the main thread publishes the status. The world alone decides
/// membership: this shell waits for exactly the robots that the truth names, and evaluates an unfinished step
/// with what it has when the next truth arrives (free pacing, or a world that stopped waiting).
///
/// A robot behind a bridge has the bridge's session and time. It is never waited for; its transmission enters
/// the step that is evaluated next; its receptions carry the stamp of the frame that it answered last.
class RadioShell {
 public:
  /// @param trace  records what each step adds to the radio's hash chain; null: no trace
  RadioShell(const MediumConfig& config, const Fleet& fleet, const runtime::BusConfig& bus,
             std::unique_ptr<runtime::TraceFile> trace, runtime::Loop& loop);
  ~RadioShell();
  RadioShell(const RadioShell&) = delete;
  RadioShell& operator=(const RadioShell&) = delete;

  /// Runs until the loop is stopped. @return the exit code
  int run();

 private:
  using Time = std::chrono::nanoseconds;

  struct Robot {
    runtime::Tenure agent;
    /// The latest one of a session whose truth has not arrived: agents answer the first frame before it.
    std::optional<caravan_interfaces::msg::RadioTransmit> early;
    std::optional<Time> sent_at;  // stamp of the latest transmission
    bool is_body = false;         // behind a bridge
    std::uint64_t session = 0;    // session of a body's bridge
    Transmission pending;         // not evaluated yet; its tuned channel stays valid
  };

  void on_truth(const caravan_interfaces::msg::WorldTruth& sample, const runtime::Sender& sender);
  void take_truth(const caravan_interfaces::msg::WorldTruth& sample);
  void on_transmit(std::uint32_t robot, const caravan_interfaces::msg::RadioTransmit& sample,
                   const runtime::Sender& sender);
  void take_transmit(Robot& from, const caravan_interfaces::msg::RadioTransmit& sample);
  /// Handles the loss of a participant or of one of its writers; either counts as leaving.
  void forget(const runtime::Discovery& gone);
  /// Gives the role to the next participant that has claimed it.
  void hand_over(runtime::Tenure& tenure);
  void read_mailbox();
  void on_control(const caravan_interfaces::msg::ControlRequest& request);
  void reply(const pure::Outcome& outcome);
  void reply(const std::vector<pure::Outcome>& outcomes);
  /// A session of the world begins: resets everything.
  void begin_session(std::uint64_t session);
  /// The same for a body's own session.
  [[nodiscard]] static bool follow_bridge(Robot& robot, std::uint64_t session);
  [[nodiscard]] std::vector<std::uint32_t> awaited() const;
  void evaluate_if_complete();
  void evaluate();
  void publish_receptions(const std::vector<Reception>& receptions,
                          const builtin_interfaces::msg::Time& stamp);
  void publish_status();

  const MediumConfig config_;
  const std::unique_ptr<runtime::TraceFile> trace_;
  runtime::Loop& loop_;
  const double lease_s_;

  std::mutex mutex_;
  std::uint64_t session_ = 0;
  std::vector<Robot> robots_;                                // [0] is robot 1
  std::optional<caravan_interfaces::msg::WorldTruth> open_;  // the step that is not yet evaluated
  Time newest_{-1};                                          // stamp of the latest truth
  runtime::Tenure world_;
  bool has_truth_ = false;       // of session_, from the present world
  std::uint64_t next_step_ = 0;  // the step after that of the latest truth
  RadioControl control_;
  pure::HashChain chain_;
  Drops drops_;
  std::uint64_t steps_ = 0;
  std::uint64_t deliveries_ = 0;
  std::uint64_t stale_samples_ = 0;
  std::uint64_t refused_writes_ = 0;
  bool told_refused_writes_ = false;
  std::chrono::nanoseconds compute_{0};

  runtime::Mailbox<runtime::Discovery> mailbox_{loop_};  // lost participants

  runtime::Bus bus_;  // after the state, so that no callback outlives it
  runtime::Writer<caravan_interfaces::msg::RadioStepPubSubType> radio_steps_;
  std::vector<runtime::Writer<caravan_interfaces::msg::RadioReceivePubSubType>> receives_;
  runtime::Writer<caravan_interfaces::msg::RadioStatusPubSubType> statuses_;
  runtime::Writer<caravan_interfaces::msg::ControlReplyPubSubType> replies_;
};

}  // namespace caravan::radio
