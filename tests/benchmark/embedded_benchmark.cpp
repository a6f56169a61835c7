// SPDX-License-Identifier: Apache-2.0
// Each part of a step of the embedded engine alone, with the inputs that it had in a recorded run of
// scaling.toml, and the whole step. One iteration is one step of all robots; embedded_speed.py makes the
// table.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <numbers>

#include "experiment/embedded/engine.hpp"
#include "radio_emulator/medium/chain.hpp"
#include "robot_agent/controller/paper_controller.hpp"
#include "runtime/pure/hash_chain.hpp"
#include "tests/benchmark/recorded_run.hpp"
#include "world_server/physics/dynamics.hpp"
#include "world_server/sensors/sonar.hpp"

namespace caravan::benchmarks {
namespace {

/// The recorded run with this number of robots: some simulated seconds, recorded once.
const RecordedRun& run_of(std::int64_t robots) {
  static std::map<std::int64_t, RecordedRun> runs;
  const auto known = runs.find(robots);
  if (known != runs.end()) return known->second;
  const std::int64_t steps = std::clamp<std::int64_t>(30000 / robots, 60, 3000);
  return runs.emplace(robots, record_run(static_cast<std::size_t>(robots), static_cast<std::size_t>(steps)))
      .first->second;
}

/// Repeats the recorded steps; `restart` resets the part before the first step, untimed.
template <typename Restart, typename Step>
void repeat(benchmark::State& state, Restart restart, Step step) {
  const RecordedRun& run = run_of(state.range(0));
  std::size_t i = run.steps.size();
  for (auto _ : state) {
    if (i == run.steps.size()) {
      state.PauseTiming();
      restart(run);
      i = 0;
      state.ResumeTiming();
    }
    step(run, i++);
  }
}

void physics(benchmark::State& state) {
  std::unique_ptr<world::Dynamics> dynamics;
  repeat(
      state,
      [&](const RecordedRun& run) { dynamics = std::make_unique<world::Dynamics>(run.world, run.starts); },
      [&](const RecordedRun& run, std::size_t i) {
        const auto& commands = run.steps[i].commands;
        for (std::size_t k = 0; k < commands.size(); ++k)
          dynamics->drive(k, commands[k]->left_mps, commands[k]->right_mps);
        dynamics->advance();
      });
}

void sonar(benchmark::State& state) {
  std::unique_ptr<world::Sonars> sonars;
  repeat(
      state, [&](const RecordedRun& run) { sonars = std::make_unique<world::Sonars>(run.world); },
      [&](const RecordedRun& run, std::size_t i) {
        sonars->place(run.steps[i].poses);
        for (std::size_t k = 0; k < run.starts.size(); ++k) benchmark::DoNotOptimize(sonars->ranges(k));
      });
}

void radio_medium(benchmark::State& state) {
  pure::HashChain chain;
  radio::Drops drops;
  repeat(
      state, [](const RecordedRun&) {},
      [&](const RecordedRun& run, std::size_t i) {
        const RecordedStep& step = run.steps[i];
        const auto receptions = radio::deliver(run.radio, i, step.stations, step.transmissions, drops);
        chain.link(radio::chain_link(0, step.transmissions, receptions).view());
      });
  benchmark::DoNotOptimize(chain.value());
}

void agent_steps(benchmark::State& state) {
  std::vector<std::unique_ptr<agent::PaperController>> agents;
  repeat(
      state,
      [&](const RecordedRun& run) {
        agents.clear();
        for (const agent::Config& config : run.agents)
          agents.push_back(std::make_unique<agent::PaperController>(config));
      },
      [&](const RecordedRun& run, std::size_t i) {
        for (std::size_t k = 0; k < agents.size(); ++k)
          benchmark::DoNotOptimize(agents[k]->step(run.steps[i].inputs[k]));
      });
}

void whole_step(benchmark::State& state) {
  const runtime::TomlDocument scenario = scaling_scenario(static_cast<std::size_t>(state.range(0)));
  std::unique_ptr<experiment::Engine> engine;
  repeat(
      state, [&](const RecordedRun&) { engine = std::make_unique<experiment::Engine>(scenario); },
      [&](const RecordedRun&, std::size_t) { benchmark::DoNotOptimize(&engine->step()); });
}

/// Robots on a spiral that all drive towards its centre; after some seconds each touches its neighbours.
void jam(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  world::WorldConfig config = run_of(15).world;
  std::vector<world::Pose> starts;
  for (std::size_t i = 0; i < count; ++i) {
    const double radius = 0.45 * std::sqrt(static_cast<double>(i) + 0.5);
    const double angle = std::numbers::pi * (3.0 - std::sqrt(5.0)) * static_cast<double>(i);
    starts.push_back({radius * std::cos(angle), radius * std::sin(angle), std::remainder(angle, 6.28)});
  }
  world::Dynamics dynamics{config, starts};
  const auto step = [&] {
    for (std::size_t k = 0; k < count; ++k) {
      const world::Pose& pose = dynamics.poses()[k];
      const double bearing = std::atan2(-pose.y_m, -pose.x_m);
      const double turn =
          std::clamp(std::remainder(bearing - pose.yaw_rad, 2.0 * std::numbers::pi), -0.5, 0.5);
      dynamics.drive(k, 1.0 - turn, 1.0 + turn);
    }
    dynamics.advance();
  };
  for (int i = 0; i < 300; ++i) step();
  for (auto _ : state) step();
  state.counters["touches"] = static_cast<double>(dynamics.touches().size());
}

void fleets(benchmark::internal::Benchmark* one) {
  for (const int robots : {1, 5, 15, 50, 100, 500, 1000}) one->Arg(robots);
  one->Unit(benchmark::kMicrosecond);
}

BENCHMARK(physics)->Apply(fleets);
BENCHMARK(sonar)->Apply(fleets);
BENCHMARK(radio_medium)->Apply(fleets);
BENCHMARK(agent_steps)->Apply(fleets);
BENCHMARK(whole_step)->Apply(fleets);
BENCHMARK(jam)->Arg(15)->Arg(100)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace caravan::benchmarks

BENCHMARK_MAIN();
