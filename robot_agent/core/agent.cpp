// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/agent.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <variant>

#include "robot_agent/core/path/merge.hpp"
#include "robot_agent/core/radio/communication.hpp"
#include "robot_agent/core/sensing/surfaces.hpp"
#include "robot_agent/core/sensing/unseen_obstacles.hpp"
#include "robot_agent/core/task/carrier.hpp"
#include "robot_agent/core/task/explorer.hpp"

namespace caravan::agent {
namespace {

constexpr std::uint64_t kDrivingStream = 0x6472697665ULL;

bool knows_where_it_is(const Sensors& sensors) {
  return std::isfinite(sensors.p_WB.x()) && std::isfinite(sensors.p_WB.y()) &&
         std::isfinite(sensors.yaw_WB_rad);
}

std::string where(const Point& p_W) { return in_detail("x_m", p_W.x()) + " " + in_detail("y_m", p_W.y()); }

}  // namespace

/// Algorithm 1. Communication does lines 2 and 14 to 18 (WAIT, the receiver queue, the exchange), Explorer
/// lines 3 to 10, Carrier lines 12 and 13.
struct Agent::Impl {
  explicit Impl(const Config& its_config)
      : config{its_config},
        communication{{config.id, config.sharing, config.wait, config.air}},
        driver{{config.body, config.driving, config.meeting, config.manoeuvres, config.recovery,
                config.keep_clear, config.passage}},
        neighbours{config.neighbours, config.wait.period},
        surfaces{config.surfaces, config.patience, config.obstacles.places > 0},
        unseen_obstacles{{config.obstacles, config.touch, config.vanishing_echo, config.patience, config.body,
                          config.smoothing.vision_radius_m}},
        random{config.seed, pure::mix_all(kDrivingStream, config.id.value)},
        task{Explorer{{config.task, config.exploration, config.recording, config.passage, config.body}}} {}

  Outputs step(const Inputs& inputs);
  [[nodiscard]] const Path& own_path() const;
  [[nodiscard]] std::optional<Perception> perceive(const Inputs& inputs, bool robot_heard, Notes& notes);
  [[nodiscard]] Motion decide(const Perception& seen, Notes& notes);
  void note_touch(const Perception& seen, bool drove_forward, Notes& notes);
  void take(const Path& received, const Point& p_WB, Notes& notes);
  void begin_carrying(Path path, Origin from, const Point& p_WB, Notes& notes);
  void report(const Motion& motion, AirOutputs& air, Notes& notes, Outputs& outputs);

  Config config;
  Communication communication;
  Driver driver;
  Neighbours neighbours;
  Surfaces surfaces;
  UnseenObstacles unseen_obstacles;
  Wheels told;  // commanded in the previous step
  pure::Random random;
  std::variant<Explorer, Carrier> task;
  Origin origin = Origin::kNone;
  std::optional<Time> robot_last_heard;
  std::optional<Point> last_p_WB;
  Time last_step{0};
  Report last_report;
  bool reported = false;
};

const Path& Agent::Impl::own_path() const {
  static const Path kNoPath;
  const auto* carrier = std::get_if<Carrier>(&task);
  return carrier == nullptr ? kNoPath : carrier->path();
}

std::optional<Perception> Agent::Impl::perceive(const Inputs& inputs, bool robot_heard, Notes& notes) {
  if (robot_heard) robot_last_heard = inputs.now;
  if (!knows_where_it_is(inputs.sensors)) return std::nullopt;
  last_p_WB = inputs.sensors.p_WB;
  const Time remembers = std::max(config.neighbours.presence, config.wait.period + config.wait.period / 5);
  const bool near =
      config.robots_are_solid && robot_last_heard && inputs.now - *robot_last_heard <= remembers;
  std::vector<Neighbour> robots;
  if (config.robots_are_solid) robots = neighbours.now(inputs.now);
  Perception seen = agent::perceive(inputs.now, inputs.sensors, near, std::move(robots), config.sonars,
                                    config.neighbours, config.body);
  if (seen.around.is_blind()) return std::nullopt;
  surfaces.see(seen);
  seen.surfaces = surfaces.near(seen.p_WB, seen.now);
  if (const auto place = unseen_obstacles.feel(inputs.sensors, told, surfaces, seen)) {
    notes.add("obstacle_remembered", where(*place));
  }
  return seen;
}

void Agent::Impl::note_touch(const Perception& seen, bool drove_forward, Notes& notes) {
  notes.add("touched");
  if (!drove_forward) return;
  if (!seen.touched) {
    if (const auto place = unseen_obstacles.touch_ahead(surfaces, seen)) {
      notes.add("obstacle_remembered", where(*place));
    }
  }
  surfaces.touch_ahead(seen, config.body);
}

Outputs Agent::Impl::step(const Inputs& inputs) {
  Notes notes;
  const auto place = config.wait.tells_place ? whereabouts_of(inputs.sensors, driver.twist().linear_mps,
                                                              driver.twist().angular_radps)
                                             : std::nullopt;
  AirOutputs air = communication.step({inputs.now, inputs.heard, own_path(), place});
  for (const Wait& wait : air.robots) neighbours.hear(wait, last_step);
  last_step = inputs.now;
  const std::optional<Perception> seen = perceive(inputs, air.robot_near, notes);
  if (air.received && last_p_WB) take(*air.received, *last_p_WB, notes);
  if (auto* carrier = std::get_if<Carrier>(&task); carrier != nullptr && seen) carrier->sense(*seen, notes);

  Motion motion;
  if (air.stand_still && config.sharing.stop_to_exchange) {
    motion = driver.stand(Activity::kExchanging, inputs.now);
  } else if (!seen) {
    motion = driver.stand(Activity::kIdle, inputs.now);
  } else {
    motion = decide(*seen, notes);
    if (motion.obstruction == Obstruction::kTouch) note_touch(*seen, motion.drove_forward, notes);
  }

  Outputs outputs;
  outputs.wheels = told = motion.wheels;
  const auto* carrier = std::get_if<Carrier>(&task);
  outputs.gripper_closed = carrier != nullptr && carrier->gripper_closed();
  outputs.tuned = air.tuned;
  outputs.frames = std::move(air.frames);
  report(motion, air, notes, outputs);
  return outputs;
}

Motion Agent::Impl::decide(const Perception& seen, Notes& notes) {
  if (auto* carrier = std::get_if<Carrier>(&task)) return carrier->step(seen, driver, random, notes);
  auto& explorer = std::get<Explorer>(task);
  const Motion motion = explorer.step(seen, driver, random);
  if (explorer.found()) {
    begin_carrying(without_loops(*explorer.found()), Origin::kFound, seen.p_WB, notes);
  }
  return motion;
}

void Agent::Impl::take(const Path& received, const Point& p_WB, Notes& notes) {
  auto* carrier = std::get_if<Carrier>(&task);
  if (!wants_path(config.sharing.mode, carrier == nullptr ? Mode::kExplore : Mode::kTransport)) return;
  std::optional<Path> path = path_after_exchange(own_path(), received, config.sharing.merge_gain_m);
  if (!path) return;
  if (carrier == nullptr) {
    begin_carrying(std::move(*path), Origin::kReceived, p_WB, notes);
    return;
  }
  const double before = length_m(carrier->path());
  const double after = length_m(*path);
  carrier->adopt(std::move(*path), p_WB);
  notes.path_changed = true;
  notes.add("merged_path", in_detail("from_m", before) + " " + in_detail("to_m", after));
}

void Agent::Impl::begin_carrying(Path path, Origin from, const Point& p_WB, Notes& notes) {
  origin = from;
  notes.path_changed = true;
  notes.add(from == Origin::kFound ? "found_path" : "received_path", in_detail("length_m", length_m(path)));
  task = Carrier{{config.task, config.progress, config.following, config.smoothing, config.recording,
                  config.exploration, config.passage, config.obstacles, config.body},
                 std::move(path),
                 p_WB};
}

void Agent::Impl::report(const Motion& motion, AirOutputs& air, Notes& notes, Outputs& outputs) {
  const auto* carrier = std::get_if<Carrier>(&task);
  Report& now = outputs.report;
  now.mode = carrier == nullptr ? Mode::kExplore : Mode::kTransport;
  now.activity = motion.activity;
  now.origin = origin;
  now.towards_destination = carrier != nullptr && carrier->towards_destination();
  now.trips = carrier == nullptr ? 0 : carrier->trips();
  now.malformed_frames = last_report.malformed_frames + air.malformed;
  now.path_changed = notes.path_changed;
  outputs.reports = !reported || notes.path_changed || !air.ended.empty() || air.malformed > 0 ||
                    !notes.events.empty() || now.mode != last_report.mode ||
                    now.activity != last_report.activity || now.origin != last_report.origin ||
                    now.trips != last_report.trips ||
                    now.towards_destination != last_report.towards_destination;
  last_report = now;
  reported = true;
  if (!outputs.reports) return;
  if (notes.path_changed) now.path = own_path();
  now.exchanges = std::move(air.ended);
  now.events = std::move(notes.events);
}

Agent::Agent(const Config& config) : impl_{std::make_unique<Impl>(config)} {}
Agent::~Agent() = default;
Agent::Agent(Agent&&) noexcept = default;
Agent& Agent::operator=(Agent&&) noexcept = default;

Outputs Agent::step(const Inputs& inputs) { return impl_->step(inputs); }

}  // namespace caravan::agent
