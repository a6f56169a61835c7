// SPDX-License-Identifier: Apache-2.0
#include "radio_emulator/shell/radio_shell.hpp"

#include <spdlog/spdlog.h>

#include <limits>
#include <utility>

#include "idl/stamp.hpp"
#include "radio_emulator/medium/chain.hpp"
#include "runtime/process/run_process.hpp"

namespace caravan::radio {
namespace msg = caravan_interfaces::msg;
using runtime::Discovery;
using runtime::Sender;
using runtime::Tenure;
using namespace std::chrono_literals;

RadioShell::RadioShell(const MediumConfig& config, const Fleet& fleet, const runtime::BusConfig& bus,
                       std::unique_ptr<runtime::TraceFile> trace, runtime::Loop& loop)
    : config_{config},
      trace_{std::move(trace)},
      loop_{loop},
      lease_s_{bus.lease_s},
      robots_(fleet.robots),
      control_{fleet.robots},
      bus_{bus, [this](const Discovery& news) {
             if (news.kind == Discovery::Kind::kGone || news.kind == Discovery::Kind::kWriterGone)
               mailbox_.post(news);
           }} {
  for (const std::uint32_t body : fleet.bodies) robots_[body - 1].is_body = true;
  radio_steps_ = bus_.writer<msg::RadioStepPubSubType>(idl::kRadioStep);
  statuses_ = bus_.writer<msg::RadioStatusPubSubType>(idl::kRadioStatus);
  replies_ = bus_.writer<msg::ControlReplyPubSubType>(idl::kControlReply);
  for (std::uint32_t robot = 1; robot <= fleet.robots; ++robot) {
    receives_.push_back(bus_.writer<msg::RadioReceivePubSubType>(idl::kRadioReceive, robot));
  }
  for (std::uint32_t robot = 1; robot <= fleet.robots; ++robot) {
    robots_[robot - 1].pending.robot = robot;
    bus_.reader<msg::RadioTransmitPubSubType>(
        idl::kRadioTransmit, robot, [this, robot](const msg::RadioTransmit& sample, const Sender& sender) {
          on_transmit(robot, sample, sender);
        });
  }
  bus_.reader<msg::WorldTruthPubSubType>(
      idl::kTruth, 0,
      [this](const msg::WorldTruth& sample, const Sender& sender) { on_truth(sample, sender); });
  bus_.reader<msg::ControlRequestPubSubType>(
      idl::kControlRequest, 0,
      [this](const msg::ControlRequest& request, const Sender& /*sender*/) { on_control(request); });
}

RadioShell::~RadioShell() { bus_.close(); }

void RadioShell::begin_session(std::uint64_t session) {
  session_ = session;
  has_truth_ = false;
  open_.reset();
  newest_ = Time{-1};
  next_step_ = 0;
  control_ = RadioControl{static_cast<std::uint32_t>(robots_.size())};
  chain_ = {};
  if (trace_) trace_->restart();
  for (Robot& robot : robots_) {
    if (robot.is_body) continue;  // its bridge has its own session
    robot.sent_at.reset();
    robot.pending.tuned = 0;
    robot.pending.frames.clear();
    const auto early = std::exchange(robot.early, std::nullopt);
    if (early && early->session() == session_) take_transmit(robot, *early);
  }
}

bool RadioShell::follow_bridge(Robot& robot, std::uint64_t session) {
  if (session < robot.session) return false;
  if (session > robot.session) {
    robot.session = session;
    robot.sent_at.reset();
    robot.pending.tuned = 0;
    robot.pending.frames.clear();
  }
  return true;
}

void RadioShell::on_truth(const msg::WorldTruth& sample, const Sender& sender) {
  const std::lock_guard lock{mutex_};
  read_mailbox();
  if (world_.claim(sender) != Tenure::Standing::kRefused) return take_truth(sample);
  ++stale_samples_;
  bus_.refuse(sender, idl::kTruth);
  world_.keep(sender, [this, sample] { take_truth(sample); });
}

void RadioShell::take_truth(const msg::WorldTruth& sample) {
  const Time stamp = idl::to_time(sample.stamp());
  // A world has one session; another world's session may have any number.
  if (sample.session() != session_ && !(has_truth_ && sample.session() < session_)) {
    begin_session(sample.session());
  }
  if (sample.session() != session_ || stamp < newest_) {
    ++stale_samples_;
    return;
  }
  if (!std::exchange(has_truth_, true))
    publish_status();  // so that observers know the radio before the first step
  if (stamp > newest_ && open_) evaluate();
  const bool evaluated_already = stamp == newest_ && !open_;
  if (stamp > newest_) {
    const Time period = idl::to_time(sample.next_stamp()) - stamp;
    const auto step = static_cast<std::uint64_t>(period > Time{0} ? stamp / period : 0);
    reply(sample.last() ? control_.end() : control_.reach(step));
    next_step_ = step + 1;
  }
  newest_ = stamp;
  if (sample.last()) publish_status();  // an observer records the final counts
  if (evaluated_already || sample.last()) return;
  open_ = sample;
  evaluate_if_complete();
}

void RadioShell::on_transmit(std::uint32_t robot, const msg::RadioTransmit& sample, const Sender& sender) {
  const std::lock_guard lock{mutex_};
  read_mailbox();
  Robot& from = robots_[robot - 1];
  if (from.agent.claim(sender) != Tenure::Standing::kRefused) return take_transmit(from, sample);
  ++stale_samples_;
  bus_.refuse(sender, idl::kRadioTransmit, robot);
  from.agent.keep(sender, [this, &from, sample] { take_transmit(from, sample); });
}

void RadioShell::read_mailbox() {
  for (const Discovery& gone : mailbox_.take()) forget(gone);
}

void RadioShell::forget(const Discovery& gone) {
  const auto concerns = [&gone](const idl::Topic& topic, std::uint32_t robot = 0) {
    return gone.kind == Discovery::Kind::kGone || gone.topic == idl::name_for(topic, robot);
  };
  if (concerns(idl::kTruth) && world_.release(gone.participant)) {
    spdlog::info("{} is gone: waiting for another one", gone.identity.role);
    has_truth_ = false;
    hand_over(world_);
  }
  for (Robot& robot : robots_) {
    if (!concerns(idl::kRadioTransmit, robot.pending.robot) || !robot.agent.release(gone.participant))
      continue;
    robot.early.reset();
    robot.session = 0;
    hand_over(robot.agent);
  }
}

void RadioShell::hand_over(Tenure& tenure) {
  for (const Tenure::Later& take : tenure.hand_over()) take();
  if (const auto holder = tenure.holder()) bus_.forgive(*holder);
}

void RadioShell::take_transmit(Robot& from, const msg::RadioTransmit& sample) {
  const Time stamp = idl::to_time(sample.stamp());
  if (!from.is_body && sample.session() != session_) {
    if (!has_truth_ || sample.session() > session_) {
      from.early = sample;
    } else {
      ++stale_samples_;
    }
    return;
  }
  if ((from.is_body && !follow_bridge(from, sample.session())) || (from.sent_at && stamp <= *from.sent_at)) {
    ++stale_samples_;
    return;
  }
  from.sent_at = stamp;
  from.pending.tuned = sample.tuned_channel();
  for (const msg::RadioFrame& frame : sample.frames()) {
    from.pending.frames.push_back({frame.channel(), frame.bytes()});
  }
  evaluate_if_complete();
}

std::vector<std::uint32_t> RadioShell::awaited() const {
  std::vector<std::uint32_t> ids;
  if (!open_) return ids;
  const Time stamp = idl::to_time(open_->stamp());
  for (const std::uint32_t member : open_->members()) {
    if (member < 1 || member > robots_.size()) continue;
    if (robots_[member - 1].is_body) continue;
    const auto& sent_at = robots_[member - 1].sent_at;
    if (!sent_at || *sent_at < stamp) ids.push_back(member);
  }
  return ids;
}

void RadioShell::evaluate_if_complete() {
  if (open_ && awaited().empty()) evaluate();
}

void RadioShell::evaluate() {
  const auto began = std::chrono::steady_clock::now();
  std::vector<bool> is_member(robots_.size(), false);
  for (const std::uint32_t member : open_->members()) {
    if (member >= 1 && member <= robots_.size()) is_member[member - 1] = true;
  }
  std::vector<Station> stations;
  for (const msg::RobotTruth& robot : open_->robots()) {
    if (robot.robot() >= 1 && robot.robot() <= robots_.size() && is_member[robot.robot() - 1]) {
      stations.push_back({robot.robot(), robot.x_m(), robot.y_m()});
    }
  }
  std::vector<Transmission> transmissions;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Transmission& pending = robots_[i].pending;
    const std::uint32_t tuned = pending.tuned;
    if (is_member[i]) transmissions.push_back(std::move(pending));
    pending = {static_cast<std::uint32_t>(i + 1), tuned, {}};
  }
  const Time stamp = idl::to_time(open_->stamp());
  const std::vector<Reception> receptions = deliver(config_, static_cast<std::uint64_t>(stamp.count()),
                                                    stations, transmissions, drops_, control_.rules());
  const pure::CanonicalBytes link = chain_link(stamp.count(), transmissions, receptions);
  chain_.link(link.view());
  if (trace_) trace_->record(link.view());
  compute_ += std::chrono::steady_clock::now() - began;
  ++steps_;
  // The answer is sent before the receptions, so that the world continues while they are on their way. A late
  // answer is sent too: it shows the world that a radio that it does not wait for is present again.
  msg::RadioStep step;
  step.stamp(open_->stamp());
  step.session(session_);
  for (const Reception& reception : receptions) step.receivers().push_back(reception.robot);
  step.chain(chain_.value());
  step.controlled(control_.was_used());
  refused_writes_ += radio_steps_.write(step) ? 0U : 1U;
  publish_receptions(receptions, open_->next_stamp());
  open_.reset();
}

void RadioShell::publish_receptions(const std::vector<Reception>& receptions,
                                    const builtin_interfaces::msg::Time& stamp) {
  for (const Reception& reception : receptions) {
    const Robot& robot = robots_[reception.robot - 1];
    msg::RadioReceive sample;
    sample.stamp(robot.is_body ? idl::to_wire(robot.sent_at.value_or(Time{0})) : stamp);
    sample.session(robot.is_body ? robot.session : session_);
    for (const ReceivedFrame& frame : reception.frames) {
      msg::ReceivedFrame received;
      received.channel(frame.channel);
      received.bytes(frame.bytes);
      received.signal_strength_dbm(frame.signal_strength_dbm);
      sample.frames().push_back(std::move(received));
    }
    deliveries_ += reception.frames.size();
    refused_writes_ += receives_[reception.robot - 1].write(sample) ? 0U : 1U;
  }
}

int RadioShell::run() {
  for (;;) {
    if (loop_.wait(std::chrono::steady_clock::now() + 500ms) == runtime::Loop::Woken::kStop)
      return runtime::kDone;
    if (loop_.was_suspended_for(lease_s_)) throw runtime::BeginAnew{"suspended for longer than the lease"};
    const std::lock_guard lock{mutex_};
    read_mailbox();
    publish_status();
    if (trace_) trace_->keep_up();
  }
}

void RadioShell::publish_status() {
  msg::RadioStatus status;
  status.stamp(idl::to_wire(std::max(newest_, Time{0})));
  status.session(session_);
  status.steps(steps_);
  status.deliveries(deliveries_);
  status.over_mtu(drops_.over_mtu);
  status.bad_channel(drops_.bad_channel);
  status.lost(drops_.lost);
  status.queue_full(drops_.queue_full);
  status.stale_samples(stale_samples_);
  for (const std::uint32_t robot : awaited()) status.awaited().push_back("robot " + std::to_string(robot));
  status.compute_s(std::chrono::duration<double>(compute_).count());
  for (const runtime::Stranger& one : bus_.strangers()) status.strangers().push_back(to_text(one));
  statuses_.write(status);
  if (refused_writes_ > 0 && !told_refused_writes_) {
    spdlog::error("DDS refused a sample: the world or an agent may be waiting for it");
    told_refused_writes_ = true;
  }
}

}  // namespace caravan::radio
