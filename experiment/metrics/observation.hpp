// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/types.hpp>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

/// What an observer sees of a run, whichever engine executes it. The types are independent of those of agent
/// and world.
namespace caravan::experiment {

/// Simulated time since the session began.
using Time = std::chrono::nanoseconds;

[[nodiscard]] constexpr double in_seconds(Time time) { return static_cast<double>(time.count()) / 1e9; }

/// A place in frame W, metres.
struct Place {
  double x_m = 0.0;
  double y_m = 0.0;
  bool operator==(const Place&) const = default;
};

using caravan::Activity;
using caravan::Event;
using caravan::Exchange;
using caravan::Mode;
using caravan::Origin;

struct TruePose {
  std::uint32_t robot = 0;
  Place place{};
  double yaw_rad = 0.0;
};

/// A contact that began in the step that led to the stamp.
struct Contact {
  std::uint32_t robot = 0;
  std::uint32_t other = 0;  ///< the other robot, 0: something static
};

struct ItemEvent {
  enum class Kind : std::uint8_t { kPickUp, kDelivery };
  Kind kind = Kind::kPickUp;
  std::uint32_t robot = 0;
};

/// What one agent reports at the stamp; the report applies until its next one.
struct AgentReport {
  std::uint32_t robot = 0;
  Mode mode = Mode::kExplore;
  Activity activity = Activity::kIdle;
  Origin origin = Origin::kNone;
  bool towards_destination = false;
  std::uint32_t trips = 0;
  std::uint64_t malformed_frames = 0;  ///< received so far
  bool path_changed = false;
  std::vector<Place> path;  ///< from source to destination; meaningful when path_changed
  std::vector<Exchange> exchanges;
  std::vector<Event> events;
};

/// One stamp: the poses of all robots, the results of the step that led to it, and the agents' reports at it.
/// The last observation of a run has the results of its deciding step and no reports.
struct Observation {
  Time stamp{0};
  bool last = false;                       ///< the run is decided: no step follows, and there are no members
  std::vector<TruePose> poses;             ///< of all robots, sorted by robot
  std::vector<std::uint32_t> members;      ///< robots that take part in this step, sorted
  std::vector<Contact> contacts;           ///< of the step that led here
  std::vector<ItemEvent> item_events;      ///< of the step that led here
  std::uint32_t items_delivered = 0;       ///< total
  std::vector<AgentReport> agent_reports;  ///< at most one for each robot, sorted by robot
};

}  // namespace caravan::experiment
