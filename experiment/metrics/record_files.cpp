// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/record_files.hpp"

#include <optional>

#include "experiment/metrics/routes.hpp"

namespace caravan::experiment {
namespace {

constexpr Time kTrackPeriod = std::chrono::seconds{1};

std::string seconds(Time time) { return fixed(in_seconds(time), 3); }
std::string seconds(const std::optional<Time>& time) { return time ? seconds(*time) : std::string{}; }

const char* to_text(Activity activity) {
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

}  // namespace

RecordFiles::RecordFiles(const std::filesystem::path& folder, std::uint32_t robots)
    : tracks_{folder / "tracks.csv", {"time_s", "robot", "x_m", "y_m", "yaw_rad", "mode"}},
      trips_{folder / "trips.csv", {"robot", "trip", "picked_up_s", "delivered_s", "next_pick_up_s"}},
      events_{folder / "events.csv", {"time_s", "robot", "event", "detail"}},
      activities_{folder / "activities.csv", {"time_s", "robot", "activity"}},
      path_lengths_{folder / "path_lengths.csv", {"time_s", "robot", "length_m"}},
      robots_(robots),
      event_book_{robots} {}

RecordFiles::Robot* RecordFiles::find(std::uint32_t robot) {
  return robot == 0 || robot > robots_.size() ? nullptr : &robots_[robot - 1];
}

void RecordFiles::observe(const Observation& observation) {
  for (const EventRow& row : event_book_.observe(observation))
    events_.row({seconds(row.stamp), std::to_string(row.robot), row.event, row.detail});
  for (const ItemEvent& item : observation.item_events) {
    if (const auto ended = trip_book_.add(observation.stamp, item)) record_trip(*ended);
  }
  for (const AgentReport& report : observation.agent_reports) record_report(observation.stamp, report);
  record_tracks(observation);
}

void RecordFiles::record_report(Time stamp, const AgentReport& report) {
  Robot* robot = find(report.robot);
  if (robot == nullptr) return;
  robot->mode = report.mode;
  if (robot->activity != report.activity) {
    activities_.row({seconds(stamp), std::to_string(report.robot), to_text(report.activity)});
  }
  robot->activity = report.activity;
  if (report.path_changed && !report.path.empty()) {
    path_lengths_.row({seconds(stamp), std::to_string(report.robot), fixed(path_length_m(report.path), 3)});
  }
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

}  // namespace caravan::experiment
