// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/shell/agent_shell.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "idl/stamp.hpp"
#include "robot_agent/core/frames/codec.hpp"
#include "robot_agent/core/frames/text.hpp"
#include "robot_agent/shell/wire.hpp"
#include "runtime/config/start_error.hpp"
#include "runtime/process/run_process.hpp"
#include "runtime/pure/overload.hpp"

namespace caravan::agent {
namespace msg = caravan_interfaces::msg;
using runtime::Discovery;
using runtime::ParticipantId;
using namespace std::chrono_literals;

namespace {

constexpr auto kRadioPatience = 1s;
constexpr auto kWatchPeriod = 500ms;  // how late the radio deadline may be noticed
constexpr auto kSayWaitingAfter = 1s;

/// In the paper's form; with --log-level trace only.
void log_frames(const char* what, Time now, const std::vector<Frame>& frames) {
  if (!spdlog::should_log(spdlog::level::trace)) return;
  for (const Frame& frame : frames) {
    const std::string text =
        std::visit(pure::Overload{[](const DecodeError&) { return std::string{"malformed"}; },
                                  [](const auto& message) { return to_text(Message{message}); }},
                   decode(frame.bytes));
    spdlog::trace("{} t_s={:.3f} channel={} {}", what, std::chrono::duration<double>(now).count(),
                  frame.channel.value, text);
  }
}

}  // namespace

AgentShell::AgentShell(const Config& config, const runtime::BusConfig& bus, runtime::Loop& loop)
    : config_{config},
      loop_{loop},
      began_{std::chrono::steady_clock::now()},
      bus_{bus, [this](const Discovery& news) {
             if (news.kind == Discovery::Kind::kJoined) return;
             const std::lock_guard lock{mailbox_mutex_};
             mailbox_.push_back(news);
             loop_.notify();
           }} {
  const std::uint32_t robot = config_.id.value;
  clash_.emplace(bus_.id(), bus_.identity(),
                 std::chrono::nanoseconds{static_cast<std::int64_t>((bus.lease_s + 0.5) * 1e9)});
  commands_ = bus_.writer<msg::RobotCommandPubSubType>(idl::kCommand, robot);
  transmits_ = bus_.writer<msg::RadioTransmitPubSubType>(idl::kRadioTransmit, robot);
  telemetry_ = bus_.writer<msg::TelemetryPubSubType>(idl::kTelemetry, robot);
  // Not under the lock: making a reader waits for DDS's own locks, whose holders may be waiting for ours in a
  // callback.
  bus_.reader<msg::RadioReceivePubSubType>(
      idl::kRadioReceive, robot,
      [this](const msg::RadioReceive& sample, const ParticipantId&) { on_receive(sample); });
  bus_.reader<msg::SensorFramePubSubType>(
      idl::kSensors, robot,
      [this](const msg::SensorFrame& sample, const ParticipantId&) { on_sensors(sample); });
}

AgentShell::~AgentShell() { bus_.close(); }

bool AgentShell::follow_session(std::uint64_t session) {
  if (session < session_) return false;
  if (session == session_) return true;
  spdlog::info("session={} robot={}: starting from the initial state", session, config_.id.value);
  session_ = session;
  agent_.emplace(config_);
  now_ = heard_until_ = Time{-1};
  heard_.clear();
  waiting_.reset();
  held_.reset();
  compute_ = {};
  return true;
}

void AgentShell::on_sensors(const msg::SensorFrame& frame) {
  const std::lock_guard lock{mutex_};
  const Time stamp = idl::to_time(frame.stamp());
  if (!follow_session(frame.session()) || stamp <= now_) return;
  if (clash_->must_be_silent()) {
    held_ = frame;
    return;
  }
  if (frame.radio_due() && heard_until_ < stamp) {
    waiting_ = frame;
    waiting_until_ = std::chrono::steady_clock::now() + kRadioPatience;
    return;
  }
  step(frame);
}

void AgentShell::on_receive(const msg::RadioReceive& sample) {
  const std::lock_guard lock{mutex_};
  if (!follow_session(sample.session())) return;
  for (const msg::ReceivedFrame& frame : sample.frames()) {
    heard_.push_back({Channel{frame.channel()}, frame.bytes()});
  }
  heard_until_ = std::max(heard_until_, idl::to_time(sample.stamp()));
  if (waiting_ && !clash_->must_be_silent() && heard_until_ >= idl::to_time(waiting_->stamp()))
    step(*waiting_);
}

void AgentShell::step(const msg::SensorFrame& frame) {
  const auto began = std::chrono::steady_clock::now();
  now_ = idl::to_time(frame.stamp());
  log_frames("hears", now_, heard_);
  Outputs outputs = agent_->step({.now = now_, .sensors = to_core(frame), .heard = std::move(heard_)});
  heard_.clear();
  compute_ += std::chrono::steady_clock::now() - began;

  // Telemetry first: the world's next step needs the command, so an observer that sees the step has this
  // report already.
  if (outputs.reports) {
    msg::Telemetry telemetry = to_telemetry(outputs.report);
    telemetry.stamp(frame.stamp());
    telemetry.session(session_);
    telemetry.compute_s(std::chrono::duration<double>(compute_).count());
    if (!telemetry_.write(telemetry)) ++refused_writes_;
  }
  msg::RobotCommand command = to_command(outputs);
  command.stamp(frame.stamp());
  command.session(session_);
  if (!commands_.write(command)) ++refused_writes_;
  log_frames("sends", now_, outputs.frames);
  msg::RadioTransmit transmit = to_transmit(outputs);
  transmit.stamp(frame.stamp());
  transmit.session(session_);
  if (!transmits_.write(transmit)) ++refused_writes_;
  waiting_.reset();
}

void AgentShell::halt() {
  const std::lock_guard lock{mutex_};
  if (session_ == 0 || clash_->must_be_silent()) return;
  msg::RobotCommand stop;
  stop.stamp(idl::to_wire(std::max(now_, Time{0})));
  stop.session(session_);
  commands_.write(stop);
}

void AgentShell::watch(Wall now) {
  std::vector<Discovery> news;
  {
    const std::lock_guard lock{mailbox_mutex_};
    news.swap(mailbox_);
  }
  const std::string own_topic = idl::name_for(idl::kCommand, config_.id.value);
  for (const Discovery& one : news) {
    if (one.kind == Discovery::Kind::kWriterFound && one.topic == own_topic) {
      clash_->found(one.participant, one.identity, now);
    } else if (one.kind == Discovery::Kind::kGone) {
      clash_->vanished(one.participant);
    }
  }
  if (const auto deadline = clash_->deadline(); deadline && now >= *deadline) {
    const runtime::Identity& holder = clash_->holder();
    throw runtime::StartError{"robot " + std::to_string(config_.id.value) + " is already run by pid " +
                              std::to_string(holder.pid) + " on host " + holder.host +
                              ": stop that one or choose another number"};
  }
  if (refused_writes_ > 0 && !told_refused_writes_) {
    spdlog::error("DDS refused a sample: the world or an observer may be waiting for it");
    told_refused_writes_ = true;
  }
  if (clash_->must_be_silent()) return;
  if (held_) {
    // The world may be waiting for this answer, so that no other frame would come.
    const msg::SensorFrame frame = *std::exchange(held_, std::nullopt);
    if (frame.session() == session_ && idl::to_time(frame.stamp()) > now_) step(frame);
  }
  if (waiting_ && now >= waiting_until_) {
    spdlog::warn("radio due but silent for 1 s: stepping without it, count={}", ++radio_timeouts_);
    step(*waiting_);
  }
  if (session_ == 0 && !said_waiting_ && now - began_ >= kSayWaitingAfter) {
    spdlog::info("waiting for the world: nothing on {} yet", idl::name_for(idl::kSensors, config_.id.value));
    said_waiting_ = true;
  }
}

AgentShell::Wall AgentShell::next_deadline(Wall now) const {
  Wall deadline = now + (session_ == 0 && said_waiting_ ? 60s : Wall::duration{kWatchPeriod});
  if (const auto clash = clash_->deadline()) deadline = std::min(deadline, *clash);
  return deadline;
}

int AgentShell::run() {
  for (;;) {
    Wall deadline;
    {
      const std::lock_guard lock{mutex_};
      const Wall now = std::chrono::steady_clock::now();
      watch(now);
      deadline = next_deadline(now);
    }
    if (loop_.wait(deadline) != runtime::Loop::Woken::kStop) continue;
    halt();
    return runtime::kDone;
  }
}

}  // namespace caravan::agent
