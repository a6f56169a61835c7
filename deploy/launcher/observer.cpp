// SPDX-License-Identifier: Apache-2.0
#include "deploy/launcher/observer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "idl/stamp.hpp"

namespace caravan::deploy {
namespace msg = caravan_interfaces::msg;
using runtime::ParticipantId;

namespace {

constexpr auto kReportPatience = std::chrono::seconds{5};
constexpr std::size_t kWorthALook = 32;  // steps; an eighth of what the world may run ahead

Time from_seconds(double seconds) { return Time{std::llround(seconds * 1e9)}; }

Observation to_observation(const msg::WorldTruth& truth) {
  Observation seen;
  seen.stamp = idl::to_time(truth.stamp());
  for (const msg::RobotTruth& robot : truth.robots()) {
    seen.poses.push_back({robot.robot(), {robot.x_m(), robot.y_m()}, robot.yaw_rad()});
  }
  seen.last = truth.last();
  seen.members = truth.members();
  for (const msg::ContactEpisode& contact : truth.contacts())
    seen.contacts.push_back({contact.robot(), contact.other()});
  for (const msg::ItemEvent& event : truth.item_events()) {
    const bool delivery = event.kind() == msg::ItemEvent_Constants::DELIVERY;
    seen.item_events.push_back(
        {delivery ? ItemEvent::Kind::kDelivery : ItemEvent::Kind::kPickUp, event.robot()});
  }
  seen.items_delivered = truth.items_delivered();
  return seen;
}

AgentReport to_report(std::uint32_t robot, const msg::Telemetry& telemetry) {
  AgentReport report;
  report.robot = robot;
  report.mode = static_cast<Mode>(telemetry.mode());
  report.activity = static_cast<Activity>(telemetry.activity());
  report.origin = static_cast<Origin>(telemetry.origin());
  report.towards_destination = telemetry.towards_destination();
  report.trips = telemetry.trips();
  report.malformed_frames = telemetry.malformed_frames();
  report.path_changed = telemetry.path_changed();
  for (const msg::PathPoint& point : telemetry.path()) report.path.push_back({point.x_m(), point.y_m()});
  for (const msg::ExchangeReport& exchange : telemetry.exchanges()) {
    report.exchanges.push_back({exchange.partner(), exchange.exchange_number(), exchange.primary(),
                                exchange.completed(), from_seconds(exchange.began_s()),
                                from_seconds(exchange.ended_s())});
  }
  for (const msg::AgentEvent& event : telemetry.events())
    report.events.push_back({event.name(), event.detail()});
  return report;
}

}  // namespace

Observer::Observer(const runtime::BusConfig& bus, const std::string& name, std::uint32_t robots,
                   runtime::Loop& loop)
    : loop_{loop}, name_{name}, bus_{bus} {
  credit_ = bus_.writer<msg::RunCreditPubSubType>(idl::kRunCredit);
  for (std::uint32_t robot = 1; robot <= robots; ++robot) {
    bus_.reader<msg::TelemetryPubSubType>(
        idl::kTelemetry, robot,
        [this, robot](const msg::Telemetry& sample, const ParticipantId&) { on_telemetry(robot, sample); });
  }
  bus_.reader<msg::WorldTruthPubSubType>(
      idl::kTruth, 0, [this](const msg::WorldTruth& sample, const ParticipantId&) { on_truth(sample); });
  bus_.reader<msg::WorldStatusPubSubType>(idl::kWorldStatus, 0,
                                          [this](const msg::WorldStatus& sample, const ParticipantId&) {
                                            const std::lock_guard lock{mutex_};
                                            news_.world = sample;
                                            if (sample.state() == msg::WorldStatus_Constants::FINISHED)
                                              loop_.notify();
                                          });
  bus_.reader<msg::RadioStatusPubSubType>(idl::kRadioStatus, 0,
                                          [this](const msg::RadioStatus& sample, const ParticipantId&) {
                                            const std::lock_guard lock{mutex_};
                                            news_.radio = sample;
                                          });
  give_credit(Time{0});
}

Observer::~Observer() { bus_.close(); }

void Observer::on_truth(const msg::WorldTruth& truth) {
  const std::lock_guard lock{mutex_};
  if (truth.session() < session_) return;
  session_ = truth.session();
  if (!first_truth_) first_truth_ = std::chrono::steady_clock::now();
  if (!steps_.empty() && idl::to_time(truth.stamp()) <= steps_.back().stamp) {
    steps_.back().members = truth.members();  // the same step again, without whom it lost
    return;
  }
  steps_.push_back(to_observation(truth));
  give_out();
}

bool Observer::has_heard_all(const Observation& step) const {
  return std::all_of(step.members.begin(), step.members.end(),
                     [this](std::uint32_t robot) { return agent_compute_s_.contains(robot); }) ||
         std::chrono::steady_clock::now() - *first_truth_ > kReportPatience;
}

void Observer::give_out() {
  while (!steps_.empty() && (steps_.size() > 1 || steps_.front().last) && has_heard_all(steps_.front())) {
    Observation step = std::move(steps_.front());
    steps_.pop_front();
    const auto until = reports_.upper_bound(step.stamp);
    for (auto report = reports_.begin(); report != until; ++report) {
      step.agent_reports.push_back(std::move(report->second));
    }
    reports_.erase(reports_.begin(), until);
    std::stable_sort(step.agent_reports.begin(), step.agent_reports.end(),
                     [](const AgentReport& a, const AgentReport& b) { return a.robot < b.robot; });
    news_.last_seen = news_.last_seen || step.last;
    news_.observations.push_back(std::move(step));
  }
  if (news_.last_seen || news_.observations.size() >= kWorthALook) loop_.notify();
}

void Observer::on_telemetry(std::uint32_t robot, const msg::Telemetry& telemetry) {
  const bool is_known = telemetry.mode() <= msg::Telemetry_Constants::MODE_TRANSPORT &&
                        telemetry.activity() <= msg::Telemetry_Constants::ACTIVITY_EXCHANGING &&
                        telemetry.origin() <= msg::Telemetry_Constants::ORIGIN_RECEIVED;
  const std::lock_guard lock{mutex_};
  if (!is_known || telemetry.session() < session_) return;
  agent_compute_s_[robot] = telemetry.compute_s();
  reports_.emplace(idl::to_time(telemetry.stamp()), to_report(robot, telemetry));
  give_out();
}

Observer::News Observer::look() {
  const std::lock_guard lock{mutex_};
  give_out();
  News taken = std::exchange(news_, {});
  news_.world = taken.world;
  news_.radio = taken.radio;
  for (const auto& [robot, compute_s] : agent_compute_s_) taken.agents_compute_s += compute_s;
  return taken;
}

void Observer::give_credit(Time stamp) {
  msg::RunCredit credit;
  credit.observer(name_);
  {
    const std::lock_guard lock{mutex_};
    credit.session(session_);
  }
  credit.stamp(idl::to_wire(stamp));
  credit_.write(credit);
}

}  // namespace caravan::deploy
