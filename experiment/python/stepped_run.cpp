// SPDX-License-Identifier: Apache-2.0
#include "experiment/python/stepped_run.hpp"

#include <exception>

#include "experiment/embedded/stopwatch.hpp"
#include "experiment/metrics/metrics_json.hpp"
#include "robot_agent/config/agent_config.hpp"
#include "runtime/scenario/shared_tables.hpp"

namespace caravan::experiment {
namespace {

constexpr Time kTrackPeriod = std::chrono::seconds{1};
constexpr std::array kModes = {"none", "partial", "full"};  // in the order of agent::Sharing

RunFacts facts_of(const runtime::TomlDocument& scenario) {
  const runtime::RobotsTable robots = runtime::read_robots(scenario);
  const runtime::ExperimentTable experiment = runtime::read_experiment(scenario);
  const agent::Config agent = agent::load_config(scenario, 1);
  RunFacts facts{
      .scenario = {},
      .engine = "embedded",
      .controller = agent::Controllers{scenario}.name(),
      .mode = kModes.at(static_cast<std::size_t>(agent.sharing.mode)),
      .seed = agent.seed,
      .robots = robots.count,
      .items = experiment.items,
      .max_time = std::chrono::duration_cast<Time>(std::chrono::duration<double>{experiment.max_time_s})};
  scenario.root().read("name", facts.scenario);
  return facts;
}

}  // namespace

SteppedRun::SteppedRun(const runtime::TomlDocument& scenario)
    : engine_{scenario},
      facts_{facts_of(scenario)},
      metrics_{facts_.robots},
      event_book_{facts_.robots},
      last_{engine_.last()} {}

void SteppedRun::step() {
  Stopwatch watch;
  try {
    observe(engine_.step());
    last_ = engine_.last();
  } catch (const std::exception& error) {
    failure_ = error.what();
    throw;
  }
  if (engine_.finished()) observe(last_);
  wall_time_s_ += watch.lap_s();
}

void SteppedRun::observe(const Observation& observation) {
  metrics_.observe(observation);
  for (EventRow& row : event_book_.observe(observation)) events_.push_back(std::move(row));
  if (observation.stamp < next_track_) return;
  next_track_ = (observation.stamp / kTrackPeriod + 1) * kTrackPeriod;
  for (const TruePose& pose : observation.poses) {
    tracks_.push_back({in_seconds(observation.stamp), static_cast<double>(pose.robot), pose.place.x_m,
                       pose.place.y_m, pose.yaw_rad});
  }
}

std::string SteppedRun::metrics() const {
  RunEnd end;
  end.digest = engine_.digest();
  end.failure = failure_;
  end.time_split = engine_.time_split();
  end.refusals = engine_.refusals();
  end.wall_time_s = wall_time_s_;
  return metrics_json(facts_, metrics_.result(), end, engine_.finished() || !failure_.empty());
}

}  // namespace caravan::experiment
