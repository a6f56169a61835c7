// SPDX-License-Identifier: Apache-2.0
#include "deploy/cli/overrides.hpp"

#include <toml++/toml.h>

#include <array>
#include <filesystem>
#include <sstream>
#include <utility>

#include "robot_agent/controller/controllers.hpp"
#include "runtime/scenario/name.hpp"

namespace caravan::deploy {
namespace {

template <typename Value>
void set(toml::table& tree, std::string_view table, std::string_view key, const Value& value) {
  if (!tree.contains(table)) tree.insert(table, toml::table{});
  tree.get_as<toml::table>(table)->insert_or_assign(key, value);
}

}  // namespace

void refuse_clash(const std::string& key, const std::string& origin, const Overrides& overrides) {
  struct Option {
    const char* key;
    const char* name;
    bool is_given;
  };
  const std::array<Option, 7> options = {
      {{"algorithm.mode", "--mode", overrides.mode.has_value()},
       {"seed", "--seed", overrides.seed.has_value()},
       {"robots.count", "--robots", overrides.robots.has_value()},
       {"experiment.items", "--items", overrides.items.has_value()},
       {"experiment.max_time_s", "--max-time", overrides.max_time_s.has_value()},
       {"experiment.pacing", "--pacing", overrides.pacing.has_value()},
       {"controller.library", "--controller", overrides.controller.has_value()}}};
  for (const Option& option : options) {
    if (option.is_given && key == option.key)
      throw runtime::StartError{origin + ": " + option.name + " sets it, too; use one of the two"};
  }
}

runtime::Settings read_settings(const std::vector<std::string>& sets, const Overrides& overrides) {
  runtime::Settings settings;
  for (const std::string& text : sets) {
    runtime::Setting setting = runtime::read_setting(text, "--set");
    refuse_clash(setting.key, setting.origin, overrides);
    for (const runtime::Setting& before : settings) {
      if (before.key == setting.key)
        throw runtime::StartError{setting.origin + ": is set twice, also to " + before.value};
    }
    settings.push_back(std::move(setting));
  }
  return settings;
}

std::string absolute_controller(const std::string& given) {
  if (given.empty() || given == agent::kPaper) return given;
  return std::filesystem::absolute(given).lexically_normal();
}

std::string controller_of(const runtime::TomlDocument& scenario, const Overrides& overrides) {
  if (!overrides.controller) return agent::controller_in(scenario);
  return absolute_controller(*overrides.controller);
}

std::string effective_text(const runtime::TomlDocument& scenario, const Overrides& overrides) {
  toml::table tree = scenario.tree();
  tree.insert_or_assign("name", name_of(scenario));
  if (overrides.seed) tree.insert_or_assign("seed", static_cast<std::int64_t>(*overrides.seed));
  if (overrides.mode) set(tree, "algorithm", "mode", *overrides.mode);
  if (overrides.robots) set(tree, "robots", "count", static_cast<std::int64_t>(*overrides.robots));
  if (overrides.items) set(tree, "experiment", "items", static_cast<std::int64_t>(*overrides.items));
  if (overrides.max_time_s) set(tree, "experiment", "max_time_s", *overrides.max_time_s);
  if (overrides.pacing) set(tree, "experiment", "pacing", *overrides.pacing);
  const std::string controller = controller_of(scenario, overrides);
  if (overrides.controller || controller != agent::kPaper) set(tree, "controller", "library", controller);
  std::ostringstream text;
  text << tree << "\n";
  return text.str();
}

}  // namespace caravan::deploy
