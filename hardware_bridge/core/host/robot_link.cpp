// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/host/robot_link.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <utility>

#include "runtime/pure/overload.hpp"

namespace caravan::bridge {

using arcos::Order;
using namespace std::chrono_literals;

namespace {

constexpr Time kSyncPatience = 400ms;
constexpr unsigned kSyncAttempts = 3;
constexpr Time kOpenPatience = 1s;
constexpr Time kPulsePeriod = 500ms;
constexpr Time kGiveUpAfter = 2s;
constexpr Time kCheckPeriod = 500ms;  // of CONFIG requests while Checking
constexpr unsigned kCheckAttempts = 6;
constexpr unsigned kDisagreements = 3;
constexpr Time kAskPeriod = 1s;  // of CONFIG requests while Running
constexpr Time kAnswerPatience = 2500ms;
constexpr Time kLostAfter = 800ms;
constexpr Time kUsualCycle = 100ms;
constexpr std::uint64_t kGarbageWorthTelling = 64;

constexpr std::array kSyncs{Order::kPulse, Order::kOpen, Order::kClose};

int in_mm(double metres) { return static_cast<int>(std::lround(1000.0 * metres)); }

/// Time between two SIPs. Some firmware counts in units of 10 ms.
Time cycle_of(const arcos::Settings& settings) {
  const Time cycle = std::chrono::milliseconds{settings.sip_period_ms};
  return cycle >= 20ms ? cycle : kUsualCycle;
}

bool same_name(const std::string& a, const std::string& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char c, unsigned char d) { return std::tolower(c) == std::tolower(d); });
}

bool same_kind(const arcos::Names& names, const arcos::Settings& settings) {
  return same_name(names.type, settings.type) && same_name(names.subtype, settings.subtype);
}

}  // namespace

void RobotLink::up(Time now) {
  packets_.restart();
  reopen_ = false;
  synchronise(now, 0);
}

void RobotLink::down() {
  state_ = Down{};
  output_.clear();
  reopen_ = false;
}

void RobotLink::synchronise(Time now, unsigned attempts) {
  state_ = Synchronising{0, attempts, now + kSyncPatience};
  // A robot stopped by its watchdog resumes with the next packet of any kind, and SYNC0 is PULSE to a robot
  // whose connection is open: stop it first.
  put(Order::kStop);
  put(kSyncs[0]);
}

void RobotLink::line_anew(const std::string& why) {
  notices_.push_back({Notice::Weight::kWarning, why});
  state_ = Down{};
  reopen_ = true;
}

std::vector<arcos::Sip> RobotLink::receive(std::span<const std::uint8_t> bytes, Time now) {
  std::vector<arcos::Sip> sips;
  for (const arcos::Bytes& data : packets_.feed(bytes)) {
    auto sip = arcos::decode_sip(data);
    if (auto* syncing = std::get_if<Synchronising>(&state_)) {
      if (sip) {
        put(Order::kClose);
        syncing->step = 0;  // the deadline stays: then SYNC0 is sent again
      } else {
        hear_sync(*syncing, data, now);
      }
    } else if (const auto settings = arcos::decode_settings(data)) {
      hear_settings(*settings, now);
    } else if (sip && std::holds_alternative<Opening>(state_)) {
      state_ = Checking{now, now + kCheckPeriod};
    } else if (auto* checking = std::get_if<Checking>(&state_); checking != nullptr && sip) {
      checking->heard = now;
    } else if (auto* running = std::get_if<Running>(&state_); running != nullptr && sip) {
      running->heard = now;
      running->lag.arrived(now, cycle_);
      sips.push_back(std::move(*sip));
    }
  }
  if (auto* running = std::get_if<Running>(&state_)) {
    for (; destroyed_ < packets_.bad_checksums(); ++destroyed_) running->lag.destroyed(cycle_);
    const Time lag = running->lag.lag();
    running->behind = lag >= config_.silence || (running->behind && 2 * lag >= config_.silence);
  }
  destroyed_ = packets_.bad_checksums();
  if (packets_.stray_bytes() >= garbage_told_ + kGarbageWorthTelling && is_running()) {
    notices_.push_back(
        {Notice::Weight::kWarning,
         "garbage on the robot's line: " + std::to_string(packets_.stray_bytes()) + " bytes so far"});
    garbage_told_ = 2 * packets_.stray_bytes();
  }
  return sips;
}

void RobotLink::hear_sync(Synchronising& state, const arcos::Bytes& data, Time now) {
  if (data[0] != static_cast<std::uint8_t>(kSyncs[state.step])) return;
  if (state.step + 1 < kSyncs.size()) {
    ++state.step;
    state.deadline = now + kSyncPatience;
    put(kSyncs[state.step]);
    return;
  }
  auto names = arcos::decode_names(data);
  if (!names) return;
  names_ = std::move(names);
  open(now);
}

void RobotLink::open(Time now) {
  const int acceleration = in_mm(config_.acceleration_mps2);
  put(Order::kOpen);
  put(arcos::encode(Order::kStop));
  put(arcos::encode(Order::kSetAcceleration, acceleration));
  put(arcos::encode(Order::kSetAcceleration, -acceleration));
  put(arcos::encode(Order::kSetMaxSpeed, in_mm(config_.speed_limit_mps)));
  // Sets the limits of turning in place from those of the wheels; otherwise the robot keeps its slow
  // defaults.
  const double to_degrees = 2.0 / config_.track_m * 180.0 / std::numbers::pi;
  const int turn_acceleration = static_cast<int>(std::lround(to_degrees * config_.acceleration_mps2));
  put(arcos::encode(Order::kSetTurnAcceleration, turn_acceleration));
  put(arcos::encode(Order::kSetTurnAcceleration, -turn_acceleration));
  put(arcos::encode(Order::kSetMaxTurnRate,
                    static_cast<int>(std::lround(to_degrees * config_.speed_limit_mps))));
  if (!motors_off_) put(arcos::encode(Order::kEnable, 1));
  put(arcos::encode(Order::kSonar, 1));
  put(arcos::encode(Order::kConfig, 1));
  state_ = Opening{now + kOpenPatience};
}

void RobotLink::hear_settings(const arcos::Settings& settings, Time now) {
  if (std::holds_alternative<Opening>(state_) || std::holds_alternative<Checking>(state_)) {
    check(settings, now);
  } else if (auto* running = std::get_if<Running>(&state_)) {
    running->answers = true;
    running->unanswered.reset();
    if (running->asked.empty()) return;
    running->lag.answered(now - running->asked.front());  // if of a later question, the lag is smaller
    running->asked.pop_front();
  }
}

void RobotLink::check(const arcos::Settings& settings, Time now) {
  const bool agree = same_kind(*names_, settings) && same_name(names_->name, settings.name);
  // A robot that repeats the same answer is not garbled.
  const bool settled = ++disagreements_ >= kDisagreements && same_kind(*names_, settings);
  if (!agree) {
    note(Notice::Weight::kWarning, "the robot is " + names_->name + ", " + names_->type + " " +
                                       names_->subtype + " by SYNC2, but " + settings.name + ", " +
                                       settings.type + " " + settings.subtype +
                                       " by CONFIG: " + (settled ? "going on" : "asking again"));
  }
  if (!agree && !settled) {
    put(Order::kClose);
    state_ = Synchronising{0, 0, now + kSyncPatience};
    return;
  }
  cycle_ = cycle_of(settings);
  tell_of_watchdog(settings);
  run(now, true);
}

void RobotLink::run(Time now, bool answers) {
  disagreements_ = 0;
  state_ =
      Running{.heard = now, .pulse_due = now + kPulsePeriod, .ask_due = now + kAskPeriod, .answers = answers};
  note(Notice::Weight::kInfo,
       "robot connected: " + names_->name + ", " + names_->type + " " + names_->subtype);
}

void RobotLink::tell_of_watchdog(const arcos::Settings& settings) {
  const Time watchdog = std::chrono::milliseconds{settings.watchdog_ms};
  if (settings.watchdog_ms != 0 && watchdog <= config_.slowest_watchdog) return;
  const std::string stop = settings.watchdog_ms == 0 ? "its own watchdog is off: it never stops"
                                                     : "its own watchdog stops it only after " +
                                                           std::to_string(watchdog / 1ms) + " ms";
  notices_.push_back(
      {Notice::Weight::kWarning, "if the robot's cable is cut, " + stop + "; set it to 300 ms in the robot"});
}

void RobotLink::tick(Time now) {
  if (auto* syncing = std::get_if<Synchronising>(&state_)) {
    if (now < syncing->deadline) return;
    if (syncing->attempts + 1 >= kSyncAttempts) {
      line_anew("no robot answers on the line");
    } else {
      synchronise(now, syncing->attempts + 1);
    }
  } else if (const auto* opening = std::get_if<Opening>(&state_)) {
    if (now >= opening->deadline) synchronise(now, 0);
  } else if (auto* checking = std::get_if<Checking>(&state_)) {
    tick(*checking, now);
  } else if (auto* running = std::get_if<Running>(&state_)) {
    tick(*running, now);
  }
}

void RobotLink::tick(Checking& state, Time now) {
  if (now >= state.heard + kGiveUpAfter) return line_anew("robot silent for 2 s: connecting anew");
  if (now < state.ask_due) return;
  if (state.asked + 1 >= kCheckAttempts) {
    note(Notice::Weight::kWarning,
         "the robot does not answer CONFIG: its name, its watchdog and its reception are not checked");
    return run(now, false);
  }
  put(arcos::encode(Order::kConfig, 1));
  ++state.asked;
  state.ask_due = now + kCheckPeriod;
}

void RobotLink::tick(Running& state, Time now) {
  if (now >= state.heard + kGiveUpAfter) return line_anew("robot silent for 2 s: connecting anew");
  if (now >= state.pulse_due) {
    put(Order::kPulse);
    state.pulse_due = now + kPulsePeriod;
  }
  // No packet is in transit for longer than the lag: later answers are lost.
  while (!state.asked.empty() && now - state.asked.front() > state.lag.lag() + kLostAfter)
    state.asked.pop_front();
  const bool in_doubt = 2 * state.lag.lag() >= config_.silence && state.asked.empty();
  if (now < state.ask_due && !in_doubt) return;
  put(arcos::encode(Order::kConfig, 1));
  if (state.answers && !state.unanswered) state.unanswered = now;
  state.asked.push_back(now);
  state.ask_due = now + kAskPeriod;
}

std::string RobotLink::unsafe(Time now) const {
  const auto* running = std::get_if<Running>(&state_);
  if (running == nullptr) return "";
  if (running->unanswered && now >= *running->unanswered + kAnswerPatience) {
    return "the robot sends packets but does not receive ours (cut from host to robot?)";
  }
  if (!running->behind) return "";
  return "the robot's packets arrive " + in_seconds(running->lag.lag()) +
         " late or not at all: its line is too slow, or loses them";
}

std::optional<Time> RobotLink::next_deadline() const {
  return std::visit(
      pure::Overload{
          [](const Down&) { return std::optional<Time>{}; },
          [](const Synchronising& state) { return std::optional{state.deadline}; },
          [](const Opening& state) { return std::optional{state.deadline}; },
          [](const Checking& state) {
            return std::optional{std::min(state.ask_due, state.heard + kGiveUpAfter)};
          },
          [](const Running& state) {
            return std::optional{std::min({state.pulse_due, state.ask_due, state.heard + kGiveUpAfter})};
          }},
      state_);
}

bool RobotLink::is_heard(Time now) const {
  const auto* running = std::get_if<Running>(&state_);
  return running != nullptr && now < running->heard + config_.silence;
}

void RobotLink::send(std::span<const std::uint8_t> packet) {
  if (is_running()) output_.insert(output_.end(), packet.begin(), packet.end());
}

void RobotLink::brake() {
  if (!is_running()) return;
  put(Order::kEmergencyStop);
  stop();
}

void RobotLink::stop() {
  if (!is_running()) return;
  put(Order::kStop);
  put(arcos::encode(Order::kWheelSpeeds, 0));  // cancels earlier setpoints
}

void RobotLink::close() {
  brake();
  if (!std::holds_alternative<Down>(state_)) put(Order::kClose);
}

arcos::Bytes RobotLink::take_output() { return std::exchange(output_, {}); }
bool RobotLink::take_reopen() { return std::exchange(reopen_, false); }
std::vector<Notice> RobotLink::take_notices() { return std::exchange(notices_, {}); }

}  // namespace caravan::bridge
