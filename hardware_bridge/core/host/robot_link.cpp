// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/core/host/robot_link.hpp"

#include <cmath>
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
constexpr std::uint64_t kGarbageWorthTelling = 64;

constexpr std::array kSyncs{Order::kPulse, Order::kOpen, Order::kClose};

int in_mm(double metres) { return static_cast<int>(std::lround(1000.0 * metres)); }

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
        syncing->step = 0;  // the deadline stays: SYNC0 again when it is over
      } else {
        hear_sync(*syncing, data, now);
      }
    } else if (sip && std::holds_alternative<Opening>(state_)) {
      state_ = Running{now, now + kPulsePeriod};
      notices_.push_back({Notice::Weight::kInfo,
                          "robot connected: " + names_->name + ", " + names_->type + " " + names_->subtype});
      sips.push_back(std::move(*sip));
    } else if (const auto settings = arcos::decode_settings(data)) {
      hear_settings(*settings);
    } else if (auto* running = std::get_if<Running>(&state_); running != nullptr && sip) {
      running->heard = now;
      sips.push_back(std::move(*sip));
    }
  }
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
  put(arcos::encode(Order::kEnable, 1));
  put(arcos::encode(Order::kSonar, 1));
  put(arcos::encode(Order::kConfig, 1));
  state_ = Opening{now + kOpenPatience};
}

void RobotLink::hear_settings(const arcos::Settings& settings) {
  const Time watchdog = std::chrono::milliseconds{settings.watchdog_ms};
  if (settings.watchdog_ms != 0 && watchdog <= config_.slowest_watchdog) return;
  const std::string stop = settings.watchdog_ms == 0 ? "its own watchdog is off: it never stops"
                                                     : "its own watchdog stops it after " +
                                                           std::to_string(watchdog / 1ms) + " ms only";
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
  } else if (auto* running = std::get_if<Running>(&state_)) {
    if (now >= running->heard + kGiveUpAfter) {
      line_anew("robot silent for 2 s: connecting anew");
    } else if (now >= running->pulse_due) {
      put(Order::kPulse);
      running->pulse_due = now + kPulsePeriod;
    }
  }
}

std::optional<Time> RobotLink::next_deadline() const {
  return std::visit(
      pure::Overload{[](const Down&) { return std::optional<Time>{}; },
                     [](const Synchronising& state) { return std::optional{state.deadline}; },
                     [](const Opening& state) { return std::optional{state.deadline}; },
                     [](const Running& state) {
                       return std::optional{std::min(state.pulse_due, state.heard + kGiveUpAfter)};
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
  put(arcos::encode(Order::kWheelSpeeds, 0));  // so that nothing asked for before goes on
}

void RobotLink::close() {
  brake();
  if (!std::holds_alternative<Down>(state_)) put(Order::kClose);
}

arcos::Bytes RobotLink::take_output() { return std::exchange(output_, {}); }
bool RobotLink::take_reopen() { return std::exchange(reopen_, false); }
std::vector<Notice> RobotLink::take_notices() { return std::exchange(notices_, {}); }

}  // namespace caravan::bridge
