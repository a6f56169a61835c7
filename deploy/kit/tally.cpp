// SPDX-License-Identifier: Apache-2.0
#include "deploy/kit/tally.hpp"

#include <nlohmann/json.hpp>

#include "experiment/metrics/metrics_json.hpp"

namespace caravan::deploy {
namespace {

using Json = nlohmann::json;

/// As text, number or yes and no.
std::optional<Tally::Number> to_number(const Json& value) {
  if (value.is_number()) return value.get<double>();
  if (value.is_boolean()) return std::string{value.get<bool>() ? "yes" : "no"};
  if (value.is_string()) return value.get<std::string>();
  return std::nullopt;
}

/// `exchanges.completed` is a member of a member.
const Json* member(const Json& json, const std::string& key) {
  const std::size_t dot = key.find('.');
  const auto found = json.find(key.substr(0, dot));
  if (found == json.end()) return nullptr;
  return dot == std::string::npos ? &*found : member(*found, key.substr(dot + 1));
}

MetricKeys keys_of(const Json& metrics) {
  // Of the scenario, which the test has written itself; and what only the end of a run decides.
  const std::set<std::string> left_out{"scenario", "engine",  "mode",        "seed",     "robots",
                                       "ended",    "failure", "interrupted", "per_robot"};
  MetricKeys keys;
  for (const auto& [name, value] : metrics.items()) {
    if (left_out.contains(name)) continue;
    if (!value.is_object()) keys.of_run.insert(name);
    if (!value.is_object()) continue;
    for (const auto& [inner, ignored] : value.items()) keys.of_run.insert(name + "." + inner);
  }
  for (const auto& [name, value] : metrics.at("per_robot").at(0).items()) {
    if (name != "id") keys.of_robot.insert(name);
  }
  return keys;
}

}  // namespace

Tally::Tally(experiment::RunFacts facts)
    : facts_{std::move(facts)}, metrics_{facts_.robots}, book_{facts_.robots} {}

void Tally::observe(const experiment::Observation& observation) {
  const std::lock_guard lock{mutex_};
  metrics_.observe(observation);
  for (const experiment::EventRow& row : book_.observe(observation)) {
    Kind& kind = events_[{row.event, row.robot}];
    ++kind.count;
    kind.newest = row.detail;
  }
}

void Tally::note(const experiment::RunEnd& end) {
  const std::lock_guard lock{mutex_};
  end_ = end;
}

std::optional<Tally::Number> Tally::metric(const std::string& key, std::uint32_t robot) const {
  const std::lock_guard lock{mutex_};
  const Json json = Json::parse(experiment::metrics_json(facts_, metrics_.result(), end_, false));
  const Json& robots = json.at("per_robot");
  if (robot > robots.size()) return std::nullopt;
  const Json* found = member(robot == 0 ? json : robots[robot - 1], key);
  return found == nullptr ? std::nullopt : to_number(*found);
}

std::uint32_t Tally::events(const std::string& kind, std::uint32_t robot) const {
  const std::lock_guard lock{mutex_};
  std::uint32_t count = 0;
  for (const auto& [what, events] : events_) {
    if (what.first == kind && (robot == 0 || what.second == robot)) count += events.count;
  }
  return count;
}

std::optional<std::string> Tally::detail(const std::string& kind, std::uint32_t robot) const {
  const std::lock_guard lock{mutex_};
  const auto found = events_.find({kind, robot});
  return found == events_.end() ? std::nullopt : std::optional{found->second.newest};
}

const MetricKeys& metric_keys() {
  static const MetricKeys keys = keys_of(Json::parse(
      experiment::metrics_json({}, experiment::Metrics{1}.result(), experiment::RunEnd{}, false)));
  return keys;
}

}  // namespace caravan::deploy
