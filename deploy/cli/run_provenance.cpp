// SPDX-License-Identifier: Apache-2.0
#include "deploy/cli/run_provenance.hpp"

#include <toml++/toml.h>

#include "robot_agent/controller/controllers.hpp"
#include "runtime/provenance/collect.hpp"
#include "runtime/provenance/sha256.hpp"
#include "runtime/scenario/shared_tables.hpp"

namespace caravan::deploy {
namespace {

void add_seeds(const toml::table& table, const std::string& path,
               std::map<std::string, std::uint64_t>& seeds) {
  for (const auto& [name, node] : table) {
    const std::string key = path + std::string{name.str()};
    if (const toml::table* inner = node.as_table()) add_seeds(*inner, key + ".", seeds);
    const auto number = node.value_exact<std::int64_t>();
    if (number && *number >= 0 && key.ends_with("seed"))
      seeds.emplace(key, static_cast<std::uint64_t>(*number));
  }
}

}  // namespace

std::map<std::string, std::uint64_t> seeds_in(const runtime::TomlDocument& scenario) {
  std::map<std::string, std::uint64_t> seeds{{"seed", runtime::read_seed(scenario)}};
  add_seeds(scenario.tree(), "", seeds);
  return seeds;
}

runtime::Provenance provenance_of(const RunCommand& command, const runtime::TomlDocument& scenario,
                                  const std::string& text, const std::filesystem::path& agent) {
  runtime::Provenance provenance{.build = runtime::this_build(),
                                 .host = runtime::this_host(),
                                 .command_line = command.command_line,
                                 .seeds = seeds_in(scenario),
                                 .scenario_sha256 = runtime::sha256(text),
                                 .transport = to_text(command.transport),
                                 .agents_per_process = command.agents_per_process,
                                 .controller = {},
                                 .agent = {}};
  const std::string controller = agent::controller_in(scenario);
  if (controller != agent::kPaper) provenance.controller = runtime::hashed(controller);
  if (!agent.empty()) provenance.agent = runtime::hashed(agent);
  return provenance;
}

}  // namespace caravan::deploy
