// SPDX-License-Identifier: Apache-2.0
#include "experiment/python/stepped_run.hpp"

#include <exception>
#include <utility>

#include "experiment/check/check_tables.hpp"
#include "experiment/embedded/stopwatch.hpp"
#include "experiment/metrics/metrics_json.hpp"

namespace caravan::experiment {
namespace {

constexpr Time kTrackPeriod = std::chrono::seconds{1};

RunFacts facts_of(const runtime::TomlDocument& scenario, const agent::Controllers& controllers) {
  RunFacts facts = check_tables(scenario);
  facts.engine = "embedded";
  facts.controller = controllers.name();
  return facts;
}

}  // namespace

SteppedRun::SteppedRun(const runtime::TomlDocument& scenario, agent::Controllers controllers)
    : facts_{facts_of(scenario, controllers)},
      engine_{scenario, std::move(controllers)},
      metrics_{facts_.robots},
      event_book_{facts_.robots},
      last_{engine_.last()} {}

void SteppedRun::step() {
  if (!failure_.empty()) throw runtime::ControllerFault{failure_};
  Stopwatch watch;
  try {
    observe(engine_.step());
    last_ = engine_.last();
  } catch (const std::exception& error) {
    failure_ = error.what();
    throw;
  }
  if (engine_.finished()) observe(last_);
  if (complaint_.empty()) complaint_ = engine_.complaint();
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
