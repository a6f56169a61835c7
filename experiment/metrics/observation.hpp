// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

/// What an observer sees of a run, whichever engine drives it: values of their own, so that neither the agent
/// nor the world is known here.
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

enum class Mode : std::uint8_t { kExplore, kTransport };
enum class Activity : std::uint8_t { kIdle, kDriving, kAvoiding, kExchanging };
enum class Origin : std::uint8_t { kNone, kFound, kReceived };

struct TruePose {
  std::uint32_t robot = 0;
  Place place{};
  double yaw_rad = 0.0;
};

/// Began in the step that led to the stamp.
struct Contact {
  std::uint32_t robot = 0;
  std::uint32_t other = 0;  ///< the other robot, 0: something static
};

struct ItemEvent {
  enum class Kind : std::uint8_t { kPickUp, kDelivery };
  Kind kind = Kind::kPickUp;
  std::uint32_t robot = 0;
};

/// One communication attempt as one of its two robots tells it, from stopping to resuming.
struct Exchange {
  std::uint32_t partner = 0;
  std::uint32_t session = 0;  ///< 0: given up before a number was known
  bool primary = false;
  bool completed = false;
  Time began{0};
  Time ended{0};
};

struct Event {
  std::string name;
  std::string detail;
};

/// What one agent says of itself at the stamp; whatever it says stays in force until its next report.
struct AgentReport {
  std::uint32_t robot = 0;
  Mode mode = Mode::kExplore;
  Activity activity = Activity::kIdle;
  Origin origin = Origin::kNone;
  bool towards_destination = false;
  std::uint32_t trips = 0;
  std::uint64_t malformed_frames = 0;  ///< heard so far
  bool path_changed = false;
  std::vector<Place> path;  ///< from source to destination; meaningful when path_changed
  std::vector<Exchange> exchanges;
  std::vector<Event> events;
};

/// One stamp: where everybody is, what the step that led here brought, and what the agents reported on
/// sensing it. The last observation of a run carries what its deciding step brought and no reports.
struct Observation {
  Time stamp{0};
  bool last = false;                   ///< the run is decided: no step follows and nobody takes part in it
  std::vector<TruePose> poses;         ///< of all robots, sorted by robot
  std::vector<std::uint32_t> members;  ///< robots that take part in this step, sorted
  std::vector<Contact> contacts;       ///< of the step that led here
  std::vector<ItemEvent> item_events;  ///< of the step that led here
  std::uint32_t items_delivered = 0;   ///< in all
  std::vector<AgentReport> agent_reports;  ///< at most one for each robot, sorted by robot
};

}  // namespace caravan::experiment
