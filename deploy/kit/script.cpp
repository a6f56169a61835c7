// SPDX-License-Identifier: Apache-2.0
#include "deploy/kit/script.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "deploy/control/words.hpp"
#include "deploy/kit/actions.hpp"
#include "deploy/kit/effective_scenario.hpp"
#include "runtime/config/toml_table.hpp"
#include "runtime/config/toml_text.hpp"
#include "runtime/scenario/shared_tables.hpp"

namespace caravan::deploy {
namespace {

/// A script's own view of its scenario.
struct Setting {
  std::uint32_t robots = 1;
  double step_s = 0.032;
};

Setting setting_of(const Script& script) {
  const auto scenario = scenario_of(script);
  Setting setting{runtime::read_robots(scenario).count, 0.032};
  scenario.table("world").read("step_s", setting.step_s, {0.001, 1.0});
  return setting;
}

/// Splits at semicolons outside quotes.
std::vector<std::string> split_actions(const std::string& text) {
  std::vector<std::string> actions(1);
  bool quoted = false;
  for (const char one : text) {
    if (one == '"') quoted = !quoted;
    if (one == ';' && !quoted) {
      actions.emplace_back();
    } else {
      actions.back() += one;
    }
  }
  std::erase_if(actions, [](const std::string& action) { return split(action).empty(); });
  return actions;
}

std::optional<Condition> read_condition(runtime::TomlTable& table, const char* key) {
  std::string text;
  table.read(key, text);
  if (text.empty()) return std::nullopt;
  try {
    return Condition{text};
  } catch (const WordsError& error) {
    table.fail(key, error.what());
  }
}

std::optional<std::uint64_t> read_hold(runtime::TomlTable& table, const Setting& setting) {
  if (table.has("at_step") && table.has("at_s")) table.fail("at_s", "a step has at_step or at_s, not both");
  std::uint32_t step = 0;
  table.read("at_step", step, {1, double{kHighestStep}});
  double time_s = 0.0;
  table.read("at_s", time_s, runtime::kTime_s);
  if (table.has("at_step")) return step;
  if (table.has("at_s"))
    return static_cast<std::uint64_t>(std::max(1.0, std::round(time_s / setting.step_s)));
  return std::nullopt;
}

ScriptStep read_step(runtime::TomlTable table, std::size_t number, const Setting& setting) {
  ScriptStep step;
  step.name = "step " + std::to_string(number);
  table.read("name", step.name);
  step.at_step = read_hold(table, setting);
  step.when = read_condition(table, "when");
  std::string actions;
  table.read("do", actions);
  try {
    step.actions = split_actions(actions);
    for (const std::string& action : step.actions) (void)read_action(action, setting.robots);
  } catch (const WordsError& error) {
    table.fail("do", error.what());
  }
  step.expectation = read_condition(table, "expect");
  double within_s = 10.0;
  table.read("within_s", within_s, {0.0, 86'400.0});
  step.within = std::chrono::milliseconds{std::llround(within_s * 1000.0)};
  table.refuse_unknown();
  return step;
}

}  // namespace

runtime::TomlDocument scenario_of(const Script& script, const std::string& controller) {
  return runtime::TomlDocument::parse(with_changes(script.scenario, script.changes, controller),
                                      script.scenario.string() + " with the script's changes",
                                      script.settings);
}

Script load_script(const std::filesystem::path& file, const runtime::Settings& settings) {
  const toml::table tree = runtime::parse_toml(runtime::read_toml_file(file, "script"), file.string());
  runtime::TomlTable root{file.string(), "", &tree};
  Script script;
  script.settings = settings;
  script.name = file.stem().string();
  root.read("name", script.name);
  std::string scenario;
  root.read("scenario", scenario);
  if (scenario.empty()) root.fail("scenario", "a script needs a scenario");
  script.scenario = file.parent_path() / scenario;
  root.read("lease_s", script.lease_s, {0.5, 60.0});
  root.read("hold_start", script.hold_start);
  root.read("agents_per_process", script.agents_per_process, {1, 65535});
  (void)root.table("changes");
  if (const toml::table* changes = tree.get_as<toml::table>("changes")) {
    std::ostringstream text;
    text << *changes;
    script.changes = text.str();
  }
  const Setting setting = setting_of(script);
  for (const runtime::TomlTable& table : root.tables("step"))
    script.steps.push_back(read_step(table, script.steps.size() + 1, setting));
  if (script.steps.empty()) root.fail("step", "a script needs at least one [[step]]");
  root.refuse_unknown();
  return script;
}

}  // namespace caravan::deploy
