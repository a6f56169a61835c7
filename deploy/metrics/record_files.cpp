// SPDX-License-Identifier: Apache-2.0
#include "deploy/metrics/record_files.hpp"

#include <algorithm>
#include <optional>

#include "deploy/metrics/routes.hpp"

namespace caravan::deploy {
namespace {

constexpr Time kTrackPeriod = std::chrono::seconds{1};

std::string seconds(Time time) { return fixed(in_seconds(time), 3); }
std::string seconds(const std::optional<Time>& time) { return time ? seconds(*time) : std::string{}; }

const char* in_words(Activity activity) {
  switch (activity) {
    case Activity::kIdle:
      return "idle";
    case Activity::kDriving:
      return "driving";
    case Activity::kAvoiding:
      return "avoiding";
    case Activity::kExchanging:
      return "exchanging";
  }
  return "";
}

std::string in_words(const Exchange& exchange) {
  return "partner=" + std::to_string(exchange.partner) + " session=" + std::to_string(exchange.session) +
         " primary=" + (exchange.primary ? "true" : "false") +
         " completed=" + (exchange.completed ? "true" : "false") + " began_s=" + seconds(exchange.began) +
         " ended_s=" + seconds(exchange.ended);
}

}  // namespace

RecordFiles::RecordFiles(const std::filesystem::path& folder, std::uint32_t robots)
    : tracks_{folder / "tracks.csv", {"time_s", "robot", "x_m", "y_m", "yaw_rad", "mode"}},
      trips_{folder / "trips.csv", {"robot", "trip", "picked_up_s", "delivered_s", "next_pick_up_s"}},
      events_{folder / "events.csv", {"time_s", "robot", "event", "detail"}},
      activities_{folder / "activities.csv", {"time_s", "robot", "activity"}},
      path_lengths_{folder / "path_lengths.csv", {"time_s", "robot", "length_m"}},
      robots_(robots) {}

RecordFiles::Robot* RecordFiles::find(std::uint32_t robot) {
  return robot == 0 || robot > robots_.size() ? nullptr : &robots_[robot - 1];
}

void RecordFiles::observe(const Observation& observation) {
  if (!observation.last) record_membership(observation);
  record_step(observation);
  for (const AgentReport& report : observation.agent_reports) record_report(observation.stamp, report);
  record_tracks(observation);
}

void RecordFiles::event(Time stamp, std::uint32_t robot, const std::string& name, const std::string& detail) {
  events_.row({seconds(stamp), std::to_string(robot), name, detail});
}

void RecordFiles::record_membership(const Observation& observation) {
  for (std::uint32_t id = 1; id <= robots_.size(); ++id) {
    Robot& robot = robots_[id - 1];
    const bool member = std::ranges::binary_search(observation.members, id);
    if (seen_members_ && member != robot.member) {
      event(observation.stamp, id, member ? "joined" : "left", "");
    }
    robot.member = member;
  }
  seen_members_ = true;
}

void RecordFiles::record_step(const Observation& observation) {
  for (const Contact& contact : observation.contacts) {
    event(observation.stamp, contact.robot, "contact",
          contact.other == 0 ? "with=static" : "with=" + std::to_string(contact.other));
  }
  for (const ItemEvent& item : observation.item_events) {
    const bool delivery = item.kind == ItemEvent::Kind::kDelivery;
    event(observation.stamp, item.robot, delivery ? "delivery" : "pick_up",
          delivery ? "items=" + std::to_string(observation.items_delivered) : "");
    if (const auto ended = trip_book_.add(observation.stamp, item)) record_trip(*ended);
  }
}

void RecordFiles::record_report(Time stamp, const AgentReport& report) {
  Robot* robot = find(report.robot);
  if (robot == nullptr) return;
  robot->mode = report.mode;
  if (robot->activity != report.activity) {
    activities_.row({seconds(stamp), std::to_string(report.robot), in_words(report.activity)});
  }
  robot->activity = report.activity;
  if (report.path_changed && !report.path.empty()) {
    path_lengths_.row({seconds(stamp), std::to_string(report.robot), fixed(path_length_m(report.path), 3)});
  }
  for (const Exchange& exchange : report.exchanges) {
    event(stamp, report.robot, "exchange", in_words(exchange));
  }
  for (const Event& own : report.events) event(stamp, report.robot, own.name, own.detail);
}

void RecordFiles::record_tracks(const Observation& observation) {
  if (observation.stamp < next_track_) return;
  next_track_ = (observation.stamp / kTrackPeriod + 1) * kTrackPeriod;
  for (const TruePose& pose : observation.poses) {
    const Robot* robot = find(pose.robot);
    if (robot == nullptr) continue;
    const char* mode = robot->activity == Activity::kExchanging ? "exchange"
                       : robot->mode == Mode::kTransport        ? "transport"
                                                                : "explore";
    tracks_.row({seconds(observation.stamp), std::to_string(pose.robot), fixed(pose.place.x_m, 4),
                 fixed(pose.place.y_m, 4), fixed(pose.yaw_rad, 5), mode});
  }
}

void RecordFiles::record_trip(const Trip& trip) {
  trips_.row({std::to_string(trip.robot), std::to_string(trip.number), seconds(trip.picked_up),
              seconds(trip.delivered), seconds(trip.next_pick_up)});
}

void RecordFiles::flush() {
  tracks_.flush();
  trips_.flush();
  events_.flush();
  activities_.flush();
  path_lengths_.flush();
}

void RecordFiles::finish() {
  for (const Trip& trip : trip_book_.open()) record_trip(trip);
}

}  // namespace caravan::deploy
