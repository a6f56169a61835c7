// SPDX-License-Identifier: Apache-2.0
#include "deploy/cli/plan_sweep.hpp"

#include <limits>

#include "deploy/cli/check_scenario.hpp"
#include "deploy/cli/overrides.hpp"
#include "experiment/sweep/modes.hpp"
#include "runtime/config/number_list.hpp"
#include "runtime/scenario/name.hpp"

namespace caravan::deploy {
namespace {

const runtime::NumberListRule kSeeds{.option = "--seeds",
                                     .lowest = 0,
                                     .highest = std::numeric_limits<std::int64_t>::max(),  // as in TOML
                                     .most = 100'000};

runtime::TomlDocument effective(const std::string& text, const SweepCommand& command) {
  return runtime::TomlDocument::parse(text, command.scenario.string() + " with the command line's changes");
}

}  // namespace

experiment::SweepPlan plan_sweep(const SweepCommand& command) {
  const auto original = runtime::TomlDocument::load(command.scenario);
  // First, because only the original has the line numbers.
  (void)check_tables(original, controller_of(original, command.overrides));
  experiment::SweepPlan plan{.scenario = name_of(original),
                             .scenario_text = effective_text(original, command.overrides),
                             .engine = command.engine,
                             .modes = experiment::read_modes(command.modes),
                             .seeds = runtime::read_number_list(command.seeds, kSeeds),
                             .runs = {}};
  const auto base = effective(plan.scenario_text, command);
  (void)check_scenario(base);
  for (const std::string& mode : plan.modes) {
    for (const std::uint64_t seed : plan.seeds) {
      Overrides one;
      one.mode = mode;
      one.seed = seed;
      plan.runs.push_back({mode, seed, effective_text(base, one)});
    }
  }
  return plan;
}

}  // namespace caravan::deploy
