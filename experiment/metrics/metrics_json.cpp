// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/metrics_json.hpp"

#include <nlohmann/json.hpp>
#include <variant>

#include "experiment/metrics/metric_table.hpp"
#include "experiment/metrics/provenance_json.hpp"
#include "runtime/pure/overload.hpp"

namespace caravan::experiment {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const MetricValue& value) {
  return std::visit(pure::Overload{[](std::monostate) { return Json(nullptr); },
                                   [](const std::vector<std::string>& lines) { return Json(lines); },
                                   [](const auto& plain) { return Json(plain); }},
                    value);
}

Json robots_json(const Result& result) {
  Json robots = Json::array();
  for (const RobotResult& robot : result.robots) {
    Json one;
    for (const RobotMetric& metric : robot_metrics())
      one[std::string{metric.key}] = to_json(metric.value(robot));
    robots.push_back(one);
  }
  return robots;
}

/// `exchanges.completed` is a member of `exchanges`.
Json& member(Json& json, std::string_view key) {
  const std::size_t dot = key.find('.');
  Json& outer = json[std::string{key.substr(0, dot)}];
  return dot == std::string_view::npos ? outer : member(outer, key.substr(dot + 1));
}

}  // namespace

std::string metrics_json(const RunFacts& facts, const Result& result, const RunEnd& end, bool ended) {
  const RunView run{facts, result, end, ended};
  Json json;
  for (const Metric& metric : metrics_table()) {
    if (metric.key.empty()) continue;
    member(json, metric.key) = metric.of_run == nullptr ? robots_json(result) : to_json(metric.of_run(run));
  }
  json["provenance"] = provenance_json(facts.provenance);
  // Bytes that are not UTF-8, in texts of other participants, are replaced.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace caravan::experiment
