// SPDX-License-Identifier: Apache-2.0
#include "deploy/observer/step_book.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "idl/stamp.hpp"

namespace caravan::deploy {
namespace msg = caravan_interfaces::msg;

namespace {

constexpr auto kReportPatience = std::chrono::seconds{10};

experiment::Time from_seconds(double seconds) { return experiment::Time{std::llround(seconds * 1e9)}; }

experiment::Observation to_observation(const msg::WorldTruth& truth) {
  experiment::Observation seen;
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
        {delivery ? experiment::ItemEvent::Kind::kDelivery : experiment::ItemEvent::Kind::kPickUp,
         event.robot()});
  }
  seen.items_delivered = truth.items_delivered();
  return seen;
}

experiment::AgentReport to_report(std::uint32_t robot, const msg::Telemetry& telemetry) {
  experiment::AgentReport report;
  report.robot = robot;
  report.mode = static_cast<experiment::Mode>(telemetry.mode());
  report.activity = static_cast<experiment::Activity>(telemetry.activity());
  report.origin = static_cast<experiment::Origin>(telemetry.origin());
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

bool is_within_limits(const msg::Telemetry& telemetry) {
  constexpr double kLongest_s = 1e9;
  const auto is_near = [](const msg::PathPoint& point) {
    return std::abs(point.x_m()) <= kFarthest_m && std::abs(point.y_m()) <= kFarthest_m;
  };
  const auto has_times = [](const msg::ExchangeReport& exchange) {
    return exchange.began_s() >= 0.0 && exchange.ended_s() >= exchange.began_s() &&
           exchange.ended_s() <= kLongest_s;
  };
  return telemetry.mode() <= msg::Telemetry_Constants::MODE_TRANSPORT &&
         telemetry.activity() <= msg::Telemetry_Constants::ACTIVITY_EXCHANGING &&
         telemetry.origin() <= msg::Telemetry_Constants::ORIGIN_RECEIVED &&
         std::ranges::all_of(telemetry.path(), is_near) &&
         std::ranges::all_of(telemetry.exchanges(), has_times);
}

}  // namespace

bool StepBook::follow_session(std::uint64_t session) {
  if (session > session_) heard_until_.clear();
  session_ = std::max(session_, session);
  return session == session_;
}

void StepBook::add(const msg::WorldTruth& truth) {
  if (!follow_session(truth.session())) return;
  if (!truth.last()) members_ = truth.members();
  if (!steps_.empty() && idl::to_time(truth.stamp()) <= steps_.back().seen.stamp) {
    steps_.back().seen.members = truth.members();  // the same step again, without lost members
  } else {
    steps_.push_back({to_observation(truth), truth.reported()});
  }
  give_out();
}

std::optional<std::uint32_t> StepBook::missing_report() const {
  if (steps_.size() < 2) return std::nullopt;
  for (const std::uint32_t robot : steps_[1].reported) {
    const auto heard = heard_until_.find(robot);
    const bool is_here = heard != heard_until_.end() && heard->second >= steps_.front().seen.stamp;
    if (!is_here && std::binary_search(members_.begin(), members_.end(), robot)) return robot;
  }
  return std::nullopt;
}

bool StepBook::may_give_out() {
  if (steps_.empty() || (steps_.size() < 2 && !steps_.front().seen.last)) return false;
  const std::optional<std::uint32_t> missing = missing_report();
  if (missing) {
    const auto now = std::chrono::steady_clock::now();
    if (!waiting_since_) waiting_since_ = now;
    if (now - *waiting_since_ < kReportPatience) return false;
    spdlog::warn("telemetry lost robot={} t={:.3f}: the records go on without it", *missing,
                 experiment::in_seconds(steps_.front().seen.stamp));
  }
  waiting_since_.reset();
  return true;
}

void StepBook::give_out() {
  while (may_give_out()) {
    experiment::Observation step = std::move(steps_.front().seen);
    steps_.pop_front();
    const auto until = reports_.upper_bound(step.stamp);
    for (auto report = reports_.begin(); report != until; ++report) {
      step.agent_reports.push_back(std::move(report->second));
    }
    reports_.erase(reports_.begin(), until);
    std::stable_sort(
        step.agent_reports.begin(), step.agent_reports.end(),
        [](const experiment::AgentReport& a, const experiment::AgentReport& b) { return a.robot < b.robot; });
    whole_.push_back(std::move(step));
  }
}

void StepBook::add(std::uint32_t robot, const msg::Telemetry& telemetry) {
  if (!follow_session(telemetry.session())) return;
  const experiment::Time stamp = idl::to_time(telemetry.stamp());
  agent_compute_s_[robot] = telemetry.compute_s();
  heard_until_[robot] = std::max(heard_until_[robot], stamp);
  if (is_within_limits(telemetry)) {
    reports_.emplace(stamp, to_report(robot, telemetry));
  } else if (refused_.insert(robot).second) {
    spdlog::warn(
        "telemetry refused robot={} t={:.3f}: a value is none of its enumeration, not finite or too large; "
        "the records go on without such reports",
        robot, experiment::in_seconds(stamp));
  }
  give_out();
}

std::vector<experiment::Observation> StepBook::take() {
  give_out();
  return std::exchange(whole_, {});
}

double StepBook::agents_compute_s() const {
  double sum_s = 0.0;
  for (const auto& [robot, compute_s] : agent_compute_s_) sum_s += compute_s;
  return sum_s;
}

}  // namespace caravan::deploy
