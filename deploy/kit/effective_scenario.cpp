// SPDX-License-Identifier: Apache-2.0
#include "deploy/kit/effective_scenario.hpp"

#include <toml++/toml.h>

#include <sstream>

#include "runtime/config/toml_table.hpp"

namespace caravan::deploy {
namespace {

void lay_over(toml::table& tree, const toml::table& changes) {
  for (const auto& [key, value] : changes) {
    toml::table* below = tree.get_as<toml::table>(key.str());
    if (below != nullptr && value.is_table()) {
      lay_over(*below, *value.as_table());
    } else {
      tree.insert_or_assign(key.str(), value);
    }
  }
}

}  // namespace

std::string with_changes(const std::filesystem::path& scenario, const std::string& changes,
                         const std::string& controller) {
  toml::table tree = runtime::TomlDocument::load(scenario).tree();
  lay_over(tree, runtime::TomlDocument::parse(changes, "changes").tree());
  if (!controller.empty()) {
    if (!tree.contains("controller")) tree.insert("controller", toml::table{});
    tree.get_as<toml::table>("controller")->insert_or_assign("library", controller);
  }
  if (toml::value<std::string>* library = tree["controller"]["library"].as_string();
      library != nullptr && *library != "paper")
    *library = std::filesystem::absolute(scenario.parent_path() / library->get()).lexically_normal();
  std::ostringstream text;
  text << tree << "\n";
  return text.str();
}

std::string with_settings(const std::string& changes, const runtime::Settings& settings) {
  std::ostringstream text;
  text << runtime::TomlDocument::parse(changes, "changes", settings).tree() << "\n";
  return text.str();
}

}  // namespace caravan::deploy
