// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/shell/hosted_agent.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "idl/stamp.hpp"
#include "robot_agent/core/radio/frames/codec.hpp"
#include "robot_agent/core/radio/frames/text.hpp"
#include "robot_agent/shell/wire.hpp"
#include "runtime/config/write_error.hpp"
#include "runtime/pure/overload.hpp"

namespace caravan::agent {
namespace msg = caravan_interfaces::msg;

namespace {

constexpr auto kRadioPatience = std::chrono::seconds{1};
constexpr const char* kStep = "a step";   // as a NotedCall
constexpr std::size_t kMostHeard = 4096;  // bound of frames between two steps, when sensor frames are missing

std::string in_words(const std::vector<std::uint8_t>& bytes) {
  return std::visit(pure::Overload{[](const DecodeError&) { return std::string{"malformed"}; },
                                   [](const auto& message) { return to_text(Message{message}); }},
                    decode(bytes));
}

std::string in_hexadecimal(const std::vector<std::uint8_t>& bytes) {
  return fmt::format("{:02x}", fmt::join(bytes, ""));
}

/// Only with --log-level trace; frames of the paper's agent in the paper's notation.
template <typename AnyFrame>
void log_frames(const char* what, Time now, const std::vector<AnyFrame>& frames, bool are_the_papers) {
  if (!spdlog::should_log(spdlog::level::trace)) return;
  for (const AnyFrame& frame : frames) {
    spdlog::trace("{} t_s={:.3f} channel={} {}", what, std::chrono::duration<double>(now).count(),
                  frame.channel, are_the_papers ? in_words(frame.bytes) : in_hexadecimal(frame.bytes));
  }
}

/// A call of a controller, and what it is while it lasts.
class NotedCall {
 public:
  NotedCall(runtime::Calls& calls, std::atomic<const char*>& called, const char* what)
      : called_{called}, call_{calls} {
    called = what;
  }

 private:
  struct Noted {
    std::atomic<const char*>& called;
    ~Noted() { called = nullptr; }
  };
  Noted called_;
  runtime::Calls::Call call_;  // ends first: a call that was given up keeps its note
};

}  // namespace

HostedAgent::HostedAgent(const Controllers& controllers, const Config& config, runtime::Bus& bus,
                         runtime::Calls& calls)
    : controllers_{controllers},
      config_{config},
      calls_{calls},
      commands_{bus.writer<msg::RobotCommandPubSubType>(idl::kCommand, robot())},
      transmits_{bus.writer<msg::RadioTransmitPubSubType>(idl::kRadioTransmit, robot())},
      telemetry_{bus.writer<msg::TelemetryPubSubType>(idl::kTelemetry, robot())} {}

bool HostedAgent::follow_session(std::uint64_t session) {
  if (session < session_ && !is_new_provider_) return false;
  is_new_provider_ = false;
  if (session == session_) return true;
  spdlog::info("session={} robot={}: starting from the initial state", session, robot());
  session_ = session;
  try {
    const NotedCall call{calls_, called_, "its constructor"};
    controller_.emplace(controllers_.make_guarded(config_));
  } catch (const runtime::StartError& error) {
    break_off(error.what());
  }
  now_ = heard_until_ = Time{-1};
  heard_.clear();
  waiting_.reset();
  held_.reset();
  compute_ = {};
  steps_ = 0;
  if (const auto early = std::exchange(early_, std::nullopt); early && early->session() == session_)
    take_in(*early);
  return true;
}

void HostedAgent::sense(const msg::SensorFrame& frame, bool may_answer) {
  const Time stamp = idl::to_time(frame.stamp());
  if (!fault_.empty() || !follow_session(frame.session()) || stamp <= now_) return;
  if (!may_answer) {
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

void HostedAgent::hear(const msg::RadioReceive& sample, bool may_answer) {
  // Sensor frames define the session; they may arrive after a radio sample of the same session.
  if (sample.session() != session_) {
    if (sample.session() > session_) early_ = sample;
    return;
  }
  take_in(sample);
  if (waiting_ && may_answer && heard_until_ >= idl::to_time(waiting_->stamp()))
    step(msg::SensorFrame{*waiting_});
}

void HostedAgent::take_in(const msg::RadioReceive& sample) {
  for (const msg::ReceivedFrame& frame : sample.frames()) {
    if (heard_.size() >= kMostHeard) break;
    heard_.push_back({frame.channel(), frame.bytes(), frame.signal_strength_dbm()});
  }
  heard_until_ = std::max(heard_until_, idl::to_time(sample.stamp()));
}

void HostedAgent::step(const msg::SensorFrame& frame) {
  if (!fault_.empty()) return;
  const auto began = std::chrono::steady_clock::now();
  now_ = idl::to_time(frame.stamp());
  waiting_.reset();
  log_frames("hears", now_, heard_, controllers_.is_paper());
  caravan::Inputs inputs{
      .now = now_, .sensors = to_sensors(frame), .heard = std::exchange(heard_, {}), .destination = {}};
  inputs.destination = controllers_.destination_in_sight(inputs.sensors, config_);
  caravan::Outputs outputs;
  ++steps_;
  called_at_ = now_;
  try {
    const NotedCall call{calls_, called_, kStep};
    outputs = controller_->step(inputs);
  } catch (const runtime::ControllerFault& fault) {
    return break_off(fault.what());
  } catch (const runtime::WriteError& error) {
    return break_off(error.what());
  }
  compute_ += std::chrono::steady_clock::now() - began;
  for (const std::string& warning : controller_->warnings()) spdlog::warn("{}", warning);
  answer(outputs, frame);
}

void HostedAgent::break_off(const std::string& fault) {
  fault_ = fault;
  halt();
}

void HostedAgent::answer(caravan::Outputs& outputs, const msg::SensorFrame& frame) {
  if (outputs.report) {
    msg::Telemetry telemetry = to_telemetry(*outputs.report);
    telemetry.stamp(frame.stamp());
    telemetry.session(session_);
    telemetry.compute_s(std::chrono::duration<double>(compute_).count());
    if (!telemetry_.write(telemetry)) ++refused_writes_;
  }
  msg::RobotCommand command = to_command(outputs);
  command.reported(outputs.report.has_value());
  command.stamp(frame.stamp());
  command.session(session_);
  if (!commands_.write(command)) ++refused_writes_;
  log_frames("sends", now_, outputs.frames, controllers_.is_paper());
  msg::RadioTransmit transmit = to_transmit(outputs);
  transmit.stamp(frame.stamp());
  transmit.session(session_);
  if (!transmits_.write(transmit)) ++refused_writes_;
}

void HostedAgent::catch_up(Wall now) {
  if (held_) {
    // The world may be waiting for this answer: then no other frame comes.
    const msg::SensorFrame frame = *std::exchange(held_, std::nullopt);
    if (frame.session() == session_ && idl::to_time(frame.stamp()) > now_) step(frame);
  }
  if (waiting_ && now >= waiting_until_) {
    spdlog::warn("radio due but silent for 1 s: stepping without it, robot={} count={}", robot(),
                 ++radio_timeouts_);
    step(msg::SensorFrame{*waiting_});
  }
}

std::string HostedAgent::call_in_words() const {
  const char* what = called_;
  if (what == nullptr) return ": a call";  // it may return just now
  if (what != kStep) return std::string{": "} + what;
  return fmt::format(", step {} ({:.3f} s):", steps_.load(),
                     std::chrono::duration<double>(called_at_.load()).count());
}

void HostedAgent::halt() {
  if (session_ == 0) return;
  msg::RobotCommand stop;
  stop.stamp(idl::to_wire(std::max(now_, Time{0})));
  stop.session(session_);
  commands_.write(stop);
}

}  // namespace caravan::agent
