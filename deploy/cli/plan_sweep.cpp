// SPDX-License-Identifier: Apache-2.0
#include "deploy/cli/plan_sweep.hpp"

#include <algorithm>
#include <limits>

#include "deploy/cli/check_scenario.hpp"
#include "deploy/cli/overrides.hpp"
#include "experiment/sweep/design.hpp"
#include "experiment/sweep/modes.hpp"
#include "experiment/sweep/plan_file.hpp"
#include "robot_agent/controller/controllers.hpp"
#include "runtime/config/number_list.hpp"
#include "runtime/provenance/collect.hpp"
#include "runtime/scenario/name.hpp"

namespace caravan::deploy {
namespace {

namespace fs = std::filesystem;
using experiment::Design;

const runtime::NumberListRule kSeeds{.option = "--seeds",
                                     .lowest = 0,
                                     .highest = std::numeric_limits<std::int64_t>::max(),  // as in TOML
                                     .most = 100'000};
constexpr std::size_t kMostRuns = 300'000;

/// Each --set is an axis, crossed with the others and with the plan.
Design read_design(const SweepCommand& command) {
  Design design;
  if (!command.plan.empty()) design = experiment::read_plan(command.plan);
  for (const std::string& text : command.sets) {
    const runtime::KeyValues read = runtime::read_key_values(text, "--set");
    Design axis{.axes = {{read.key, "--set "}}, .points = {}};
    for (const std::string& value : read.values) axis.points.push_back({value});
    design = experiment::crossed(design, axis);
  }
  return design;
}

void refuse_clashes(const Design& design, const Overrides& overrides) {
  for (const experiment::Axis& axis : design.axes) {
    const std::string origin = axis.place + axis.key;
    if (axis.key == "seed") throw runtime::StartError{origin + ": in a sweep, --seeds sets it"};
    if (axis.key == "algorithm.mode") throw runtime::StartError{origin + ": in a sweep, --modes sets it"};
    if (axis.key.find('.') == std::string::npos)
      throw runtime::StartError{origin + ": only keys of tables, such as radio.range_m, can be axes"};
    refuse_clash(axis.key, origin, overrides);
  }
}

/// Paths of controllers start from the scenario's folder, and runs start from another one.
void make_controllers_absolute(Design& design, const fs::path& scenario) {
  for (std::size_t i = 0; i < design.axes.size(); ++i) {
    if (design.axes[i].key != "controller.library") continue;
    for (std::vector<std::string>& point : design.points) {
      if (point[i] == agent::kPaper || !runtime::is_word(point[i])) continue;
      point[i] =
          runtime::value_of_text(fs::absolute(scenario.parent_path() / point[i]).lexically_normal().string());
    }
  }
}

std::string changed_name(const SweepCommand& command) {
  return command.scenario.string() + " with the command line's changes";
}

/// The scenario at a point. @throws runtime::StartError that names the setting or the point
runtime::TomlDocument scenario_at(const Design& design, std::size_t point, const std::string& text,
                                  const std::string& name) {
  const runtime::Settings settings = experiment::settings_at(design, point);
  try {
    auto scenario = runtime::TomlDocument::parse(text, name, settings);
    (void)check_scenario(scenario);
    return scenario;
  } catch (const runtime::StartError& error) {
    const std::string why = error.what();
    const bool is_named = std::ranges::any_of(settings, [&why](const runtime::Setting& setting) {
      return why.find(setting.origin) != std::string::npos;
    });
    if (is_named || settings.empty()) throw;
    throw runtime::StartError{experiment::folder_of(design, point) + ": " + why};
  }
}

/// The SHA-256 of the file of the scenario's controller, which the plan lists then; empty: the paper's agent.
std::string hash_of_controller(experiment::SweepPlan& plan, const runtime::TomlDocument& scenario) {
  const std::string file = agent::controller_in(scenario);
  if (file == agent::kPaper) return "";
  const auto known = std::ranges::find(plan.controllers, file, &runtime::HashedFile::file);
  if (known != plan.controllers.end()) return known->sha256;
  plan.controllers.push_back(runtime::hashed(file));
  return plan.controllers.back().sha256;
}

void refuse_size(std::size_t points, std::size_t runs_of_point) {
  if (points <= kMostRuns / runs_of_point) return;
  throw runtime::StartError{"the sweep has " + std::to_string(points) + " points of " +
                            std::to_string(runs_of_point) + " runs; " + std::to_string(kMostRuns) +
                            " runs are the most"};
}

}  // namespace

experiment::SweepPlan plan_sweep(const SweepCommand& command) {
  const auto original = runtime::TomlDocument::load(command.scenario);
  // First, because only the original has the line numbers.
  const auto facts = check_tables(original, controller_of(original, command.overrides));
  experiment::SweepPlan plan{.scenario = name_of(original),
                             .scenario_text = effective_text(original, command.overrides),
                             .engine = command.engine,
                             .modes = {},
                             .seeds = runtime::read_number_list(command.seeds, kSeeds),
                             .runs = {}};
  const std::string name = changed_name(command);
  Design design = read_design(command);
  refuse_clashes(design, command.overrides);
  make_controllers_absolute(design, command.scenario);
  // The modes are the paper's: another controller is not told which it is.
  const bool are_compared =
      design.axes.empty() && controller_of(original, command.overrides) == agent::kPaper;
  plan.modes =
      experiment::read_modes(command.modes.value_or(are_compared ? "none,partial,full" : facts.mode));
  refuse_size(design.points.size(), plan.modes.size() * plan.seeds.size());
  for (const experiment::Axis& axis : design.axes) plan.axes.push_back(axis.key);
  for (std::size_t point = 0; point < design.points.size(); ++point) {
    const auto scenario = scenario_at(design, point, plan.scenario_text, name);
    const std::string folder = experiment::folder_of(design, point);
    const std::string controller_sha256 = hash_of_controller(plan, scenario);
    for (const std::string& mode : plan.modes) {
      for (const std::uint64_t seed : plan.seeds) {
        Overrides one;
        one.mode = mode;
        one.seed = seed;
        plan.runs.push_back(
            {mode, seed, effective_text(scenario, one), folder, design.points[point], controller_sha256});
      }
    }
  }
  return plan;
}

}  // namespace caravan::deploy
