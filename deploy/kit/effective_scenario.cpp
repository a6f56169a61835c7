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

std::string with_changes(const std::filesystem::path& scenario, const std::string& changes) {
  toml::table tree = runtime::TomlDocument::load(scenario).tree();
  lay_over(tree, runtime::TomlDocument::parse(changes, "changes").tree());
  std::ostringstream text;
  text << tree << "\n";
  return text.str();
}

}  // namespace caravan::deploy
