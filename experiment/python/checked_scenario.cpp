// SPDX-License-Identifier: Apache-2.0
#include "experiment/python/checked_scenario.hpp"

#include <toml++/toml.h>

#include <sstream>

#include "experiment/check/check_tables.hpp"
#include "robot_agent/controller/controllers.hpp"
#include "runtime/config/setting.hpp"
#include "runtime/config/toml_table.hpp"
#include "world_server/config/world_config.hpp"
#include "world_server/world.hpp"

namespace caravan::experiment {
namespace {

runtime::Settings settings_of(const Changes& changes) {
  runtime::Settings settings;
  for (const auto& [key, value] : changes) {
    const std::string origin = "changed " + key + "=" + value;
    if (!runtime::is_key(key)) throw runtime::StartError{origin + ": is not a key such as radio.range_m"};
    settings.push_back({.key = key, .value = value, .origin = origin});
  }
  return settings;
}

/// The text of the scenario with its changes, whose folder no longer matters.
std::string text_of(const runtime::TomlDocument& scenario, const std::string& controller) {
  toml::table tree = scenario.tree();
  if (controller != agent::kPaper)
    tree.get_as<toml::table>("controller")->insert_or_assign("library", controller);
  std::ostringstream text;
  text << tree << "\n";
  return text.str();
}

}  // namespace

CheckedScenario check_scenario(const std::string& text, const std::string& file, const Changes& changes) {
  const auto scenario = runtime::TomlDocument::parse(text, file, settings_of(changes));
  const RunFacts facts = check_tables(scenario);
  const std::string controller = agent::controller_in(scenario);
  const world::World trial{world::load_world_config(scenario)};
  return {changes.empty() ? text : text_of(scenario, controller), facts};
}

}  // namespace caravan::experiment
