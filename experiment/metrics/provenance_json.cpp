// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/provenance_json.hpp"

#include <nlohmann/json.hpp>

namespace caravan::experiment {
namespace {

using Json = nlohmann::ordered_json;

Json file_json(const std::optional<runtime::HashedFile>& file) {
  if (!file) return nullptr;
  return {{"file", file->file}, {"sha256", file->sha256}};
}

std::optional<runtime::HashedFile> read_file(const nlohmann::json& json) {
  if (json.is_null()) return std::nullopt;
  return runtime::HashedFile{.file = json.at("file"), .sha256 = json.at("sha256")};
}

std::optional<bool> read_dirty(const nlohmann::json& json) {
  return json.is_null() ? std::nullopt : std::optional{json.get<bool>()};
}

}  // namespace

Json provenance_json(const runtime::Provenance& provenance) {
  const runtime::Build& build = provenance.build;
  const runtime::Host& host = provenance.host;
  return {{"version", build.version},
          {"commit", build.commit.id},
          {"dirty", build.commit.dirty ? Json(*build.commit.dirty) : Json(nullptr)},
          {"compiler", build.compiler},
          {"build_type", build.type},
          {"compiler_flags", build.flags},
          {"libraries", build.libraries},
          {"host",
           {{"processor", host.processor},
            {"architecture", host.architecture},
            {"cores", host.cores},
            {"kernel", host.kernel},
            {"release", host.release}}},
          {"command_line", provenance.command_line},
          {"seeds", provenance.seeds},
          {"scenario", {{"file", "scenario.toml"}, {"sha256", provenance.scenario_sha256}}},
          {"transport", provenance.transport},
          {"agents_per_process", provenance.agents_per_process},
          {"controller", file_json(provenance.controller)},
          {"agent", file_json(provenance.agent)}};
}

runtime::Provenance read_provenance(const nlohmann::json& json) {
  const nlohmann::json& host = json.at("host");
  return {.build = {.version = json.at("version"),
                    .commit = {.id = json.at("commit"), .dirty = read_dirty(json.at("dirty"))},
                    .compiler = json.at("compiler"),
                    .type = json.at("build_type"),
                    .flags = json.at("compiler_flags"),
                    .libraries = json.at("libraries").get<std::map<std::string, std::string>>()},
          .host = {.processor = host.at("processor"),
                   .architecture = host.at("architecture"),
                   .cores = host.at("cores"),
                   .kernel = host.at("kernel"),
                   .release = host.at("release")},
          .command_line = json.at("command_line").get<std::vector<std::string>>(),
          .seeds = json.at("seeds").get<std::map<std::string, std::uint64_t>>(),
          .scenario_sha256 = json.at("scenario").at("sha256"),
          .transport = json.at("transport"),
          .agents_per_process = json.at("agents_per_process"),
          .controller = read_file(json.at("controller")),
          .agent = read_file(json.at("agent"))};
}

std::string record_header(const runtime::Provenance& provenance, const std::string& scenario) {
  const Json json{{"provenance", provenance_json(provenance)}, {"scenario", scenario}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace caravan::experiment
