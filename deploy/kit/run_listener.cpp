// SPDX-License-Identifier: Apache-2.0
#include "deploy/kit/run_listener.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "deploy/observer/run_end.hpp"
#include "idl/robot_types.hpp"
#include "idl/stamp.hpp"
#include "robot_agent/core/radio/frames/codec.hpp"
#include "robot_agent/core/radio/frames/text.hpp"
#include "runtime/pure/overload.hpp"

namespace caravan::deploy {
namespace msg = caravan_interfaces::msg;
using runtime::ParticipantId;

namespace {

constexpr std::uint64_t kCreditEvery = 32;  // steps; an eighth of the steps that the world may run ahead
constexpr std::size_t kEventsKept = 40;

template <std::size_t size>
std::string word_at(const std::array<const char*, size>& words, std::uint8_t index) {
  return index < size ? words[index] : "unknown";
}

std::string state_of(const msg::WorldStatus& status) {
  if (status.state() == msg::WorldStatus_Constants::WAITING) return "waiting";
  if (status.state() == msg::WorldStatus_Constants::FINISHED) return "finished";
  return status.paused() ? "paused" : "running";
}

double seconds(const builtin_interfaces::msg::Time& stamp) {
  return std::chrono::duration<double>(idl::to_time(stamp)).count();
}

}  // namespace

RunListener::RunListener(const runtime::BusConfig& bus, experiment::RunFacts facts, bool hold_start)
    : facts_{std::move(facts)},
      gives_credit_{!hold_start},
      readers_{facts_.robots,
               RunReaders::Worlds::kNext,
               {.truth = [this](const msg::WorldTruth& sample) { on_truth(sample); },
                .world = [this](const msg::WorldStatus& sample) { on_status(sample); },
                .radio = [this](const msg::RadioStatus& sample) { on_radio(sample); },
                .telemetry = [this](std::uint32_t robot,
                                    const msg::Telemetry& sample) { on_telemetry(robot, sample); }}},
      bus_{bus, [this](const runtime::Discovery& news) { readers_.discovered(news); }} {
  credit_ = bus_.writer<msg::RunCreditPubSubType>(idl::kRunCredit);
  requester_.join(bus_);
  readers_.join(bus_);
  if (!hold_start) go();
}

void RunListener::overhear() {
  {
    const std::lock_guard lock{mutex_};
    if (std::exchange(overhears_, true)) return;
  }
  for (std::uint32_t robot = 1; robot <= facts_.robots; ++robot) {
    bus_.reader<msg::RadioTransmitPubSubType>(
        idl::kRadioTransmit, robot, [this, robot](const msg::RadioTransmit& sample, const ParticipantId&) {
          on_transmit(robot, sample);
        });
  }
}

RunListener::~RunListener() { bus_.close(); }

bool RunListener::follow_session(std::uint64_t session) {
  if (session < seen_.session) return false;
  if (session == seen_.session) return true;
  seen_.session = session;
  ++seen_.sessions;
  seen_.robots.clear();
  seen_.step = credited_step_ = 0;
  seen_.time_s = 0.0;
  seen_.items = seen_.members = 0;
  seen_.digest.clear();
  book_ = {};
  seen_.tally = tally_ = std::make_shared<Tally>(facts_);
  note("session " + std::to_string(session));
  return true;
}

void RunListener::note(const std::string& event) {
  seen_.events.push_back(event);
  if (seen_.events.size() > kEventsKept) seen_.events.pop_front();
}

void RunListener::give_credit(const builtin_interfaces::msg::Time& stamp) {
  msg::RunCredit credit;
  credit.observer(kName);
  credit.session(seen_.session);
  credit.stamp(stamp);
  credit_.write(credit);
}

void RunListener::count() {
  for (const experiment::Observation& step : book_.take()) tally_->observe(step);
}

void RunListener::on_truth(const msg::WorldTruth& truth) {
  const std::lock_guard lock{mutex_};
  if (!follow_session(truth.session())) return;
  book_.add(truth);
  count();
  const auto stamp = idl::to_time(truth.stamp());
  const auto period = idl::to_time(truth.next_stamp()) - stamp;
  const auto step = static_cast<std::uint64_t>(period.count() > 0 ? stamp / period : 0);
  seen_.step = std::max(seen_.step, step);
  seen_.time_s = seconds(truth.stamp());
  seen_.items = truth.items_delivered();
  if (!truth.last()) seen_.members = static_cast<std::uint32_t>(truth.members().size());
  for (auto& [number, robot] : seen_.robots) robot.is_member = robot.is_member && truth.last();
  for (const msg::RobotTruth& one : truth.robots()) {
    SeenRobot& robot = seen_.robots[one.robot()];
    robot.x_m = one.x_m();
    robot.y_m = one.y_m();
    robot.yaw_rad = one.yaw_rad();
    if (!truth.last()) {
      robot.is_member =
          std::find(truth.members().begin(), truth.members().end(), one.robot()) != truth.members().end();
    }
  }
  for (const msg::ItemEvent& event : truth.item_events()) {
    const bool delivery = event.kind() == msg::ItemEvent_Constants::DELIVERY;
    note("t=" + std::to_string(seen_.time_s) + " robot " + std::to_string(event.robot()) +
         (delivery ? " delivers" : " picks up"));
  }
  if (gives_credit_ && step >= credited_step_ + kCreditEvery) {
    credited_step_ = step;
    give_credit(truth.stamp());
  }
  has_news_ = true;
  news_.notify_all();
}

void RunListener::on_status(const msg::WorldStatus& status) {
  const std::lock_guard lock{mutex_};
  if (!follow_session(status.session())) return;
  const std::string state = state_of(status);
  if (state != seen_.state) note("world " + state + " at step " + std::to_string(status.steps()));
  if (status.gone() != seen_.gone || status.hung() != seen_.hung) {
    for (const std::string& name : status.gone()) note("gone " + name);
    for (const std::string& name : status.hung()) note("hung " + name);
  }
  seen_.state = state;
  seen_.step = std::max(seen_.step, static_cast<std::uint64_t>(status.steps()));
  seen_.missing = status.missing();
  seen_.hung = status.hung();
  seen_.gone = status.gone();
  seen_.removed = status.removed();
  seen_.disturbed = status.disturbed();
  seen_.digest = status.digest();
  seen_.refused_commands = status.refused_commands();
  world_ = status;
  tally_->note(run_end(world_, radio_, book_.agents_compute_s()));
  has_news_ = true;
  news_.notify_all();
}

void RunListener::on_radio(const msg::RadioStatus& status) {
  const std::lock_guard lock{mutex_};
  seen_.radio_is_heard = true;
  seen_.deliveries = status.deliveries();
  seen_.lost_frames = status.lost();
  radio_ = status;
  if (tally_) tally_->note(run_end(world_, radio_, book_.agents_compute_s()));
  has_news_ = true;
  news_.notify_all();
}

void RunListener::on_telemetry(std::uint32_t robot, const msg::Telemetry& telemetry) {
  constexpr std::array kModes{"explore", "transport"};
  constexpr std::array kActivities{"idle", "driving", "avoiding", "exchanging"};
  constexpr std::array kOrigins{"none", "found", "received"};
  const std::lock_guard lock{mutex_};
  if (!follow_session(telemetry.session())) return;
  book_.add(robot, telemetry);
  count();
  SeenRobot& one = seen_.robots[robot];
  const std::string mode = word_at(kModes, telemetry.mode());
  const std::string who =
      "t=" + std::to_string(seconds(telemetry.stamp())) + " robot " + std::to_string(robot);
  if (!one.has_reported || one.mode != mode) note(who + " reports " + mode);
  one.has_reported = true;
  one.mode = mode;
  one.activity = word_at(kActivities, telemetry.activity());
  one.origin = word_at(kOrigins, telemetry.origin());
  one.trips = telemetry.trips();
  for (const msg::ExchangeReport& exchange : telemetry.exchanges()) {
    ++(exchange.completed() ? one.exchanges : one.failed_exchanges);
    note(who + (exchange.completed() ? " completes" : " fails") + " an exchange with robot " +
         std::to_string(exchange.partner()));
  }
  for (const msg::AgentEvent& event : telemetry.events())
    note(who + " " + event.name() + " " + event.detail());
  has_news_ = true;
  news_.notify_all();
}

void RunListener::on_transmit(std::uint32_t robot, const msg::RadioTransmit& transmit) {
  std::string sent;
  for (const msg::RadioFrame& frame : transmit.frames()) {
    const std::string text = std::visit(
        pure::Overload{[](agent::DecodeError) { return std::string{"malformed"}; },
                       [](const auto& message) { return agent::to_text(agent::Message{message}); }},
        agent::decode(frame.bytes()));
    sent += (sent.empty() ? "" : " ") + text;
  }
  const std::lock_guard lock{mutex_};
  if (transmit.session() != seen_.session) return;
  seen_.robots[robot].sent = sent;
  has_news_ = true;
  news_.notify_all();
}

Seen RunListener::seen() const {
  const std::lock_guard lock{mutex_};
  has_news_ = false;
  return seen_;
}

void RunListener::wait_for_news(std::chrono::milliseconds patience) {
  std::unique_lock lock{mutex_};
  news_.wait_for(lock, patience, [this] { return has_news_; });
}

void RunListener::forget_world() {
  const std::lock_guard lock{mutex_};
  seen_.state = "absent";
  seen_.missing.clear();
  seen_.hung.clear();
  seen_.gone.clear();
  seen_.removed.clear();
}

void RunListener::forget_radio() {
  const std::lock_guard lock{mutex_};
  seen_.radio_is_heard = false;
}

void RunListener::go() {
  const std::lock_guard lock{mutex_};
  gives_credit_ = true;
  give_credit({});
}

ControlAnswer RunListener::ask(msg::ControlRequest request, std::chrono::milliseconds patience) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  {
    std::unique_lock lock{mutex_};
    if (!news_.wait_until(lock, deadline, [this] { return seen_.state != "absent"; }))
      return {ControlAnswer::Kind::kNone, 0, "no world appeared within the time"};
    request.session(seen_.session);
  }
  return requester_.ask(request, std::chrono::duration_cast<std::chrono::milliseconds>(
                                     deadline - std::chrono::steady_clock::now()));
}

}  // namespace caravan::deploy
