// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/metrics.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "experiment/metrics/routes.hpp"

namespace caravan::experiment {

Metrics::Metrics(std::uint32_t robots) : robots_(robots), paths_(robots) {}

Metrics::Robot* Metrics::find(std::uint32_t robot) {
  return robot == 0 || robot > robots_.size() ? nullptr : &robots_[robot - 1];
}

void Metrics::observe(const Observation& observation) {
  book_time_until(observation.stamp);
  count_step(observation);
  for (const TruePose& pose : observation.poses) {
    if (Robot* robot = find(pose.robot)) robot->place = pose.place;
  }
  for (Robot& robot : robots_) robot.present = false;
  for (const std::uint32_t member : observation.members) {
    if (Robot* robot = find(member)) robot->present = true;
  }
  for (const AgentReport& report : observation.agent_reports) take(report);
}

void Metrics::book_time_until(Time stamp) {
  const Time passed = stamp - now_;
  if (passed <= Time{0}) return;
  for (Robot& robot : robots_) {
    robot.account.add(now_, passed, robot.place, robot.activity, robot.present);
  }
  now_ = stamp;
}

void Metrics::count_step(const Observation& observation) {
  items_delivered_ = observation.items_delivered;
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;  // either side may report a contact, or both
  for (const Contact& contact : observation.contacts) {
    if (contact.other == 0) {
      ++robot_static_contacts_;
    } else if (pairs.insert(std::minmax(contact.robot, contact.other)).second) {
      ++robot_robot_contacts_;
    }
  }
  for (const ItemEvent& event : observation.item_events) {
    Robot* robot = find(event.robot);
    if (robot != nullptr && event.kind == ItemEvent::Kind::kDelivery) ++robot->items;
    if (const auto ended = trips_.add(observation.stamp, event)) {
      round_trips_ += *ended->next_pick_up - ended->picked_up;
      ++round_trip_count_;
    }
  }
}

void Metrics::take(const AgentReport& report) {
  Robot* robot = find(report.robot);
  if (robot == nullptr) return;
  robot->mode = report.mode;
  robot->activity = report.activity;
  robot->malformed_frames = report.malformed_frames;
  const bool first_path = !robot->found && !robot->received;
  if (first_path && report.origin == Origin::kFound) robot->found = now_;
  if (first_path && report.origin == Origin::kReceived) robot->received = now_;
  if (report.path_changed) paths_[report.robot - 1] = report.path;
  for (const Exchange& exchange : report.exchanges) exchanges_.add(report.robot, exchange);
}

Result Metrics::result() const {
  Result result{.sim_time = now_,
                .items_delivered = items_delivered_,
                .routes = count_routes(paths_),
                .exchanges_completed = exchanges_.completed(),
                .exchanges_failed = exchanges_.failed(),
                .exchange_mean_s = exchanges_.mean_duration_s(),
                .robot_robot_contacts = robot_robot_contacts_,
                .robot_static_contacts = robot_static_contacts_};
  if (round_trip_count_ > 0) {
    result.round_trip_mean_s = in_seconds(round_trips_) / static_cast<double>(round_trip_count_);
  }
  for (std::uint32_t id = 1; id <= robots_.size(); ++id) {
    const Robot& robot = robots_[id - 1];
    const auto& path = paths_[id - 1];
    result.malformed_frames += robot.malformed_frames;
    result.robots.push_back(
        {.id = id,
         .found = robot.found,
         .received = robot.received,
         .items = robot.items,
         .path_length_m = path.empty() ? std::nullopt : std::optional{path_length_m(path)},
         .times = robot.account.times()});
  }
  return result;
}

Progress Metrics::progress() const {
  const auto with_path = std::ranges::count(robots_, Mode::kTransport, &Robot::mode);
  return {.stamp = now_,
          .items_delivered = items_delivered_,
          .robots_with_path = static_cast<std::uint32_t>(with_path),
          .exchanges_completed = exchanges_.completed(),
          .exchanges_failed = exchanges_.failed()};
}

}  // namespace caravan::experiment
