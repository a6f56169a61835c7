// SPDX-License-Identifier: Apache-2.0
#include "experiment/sweep/quantities.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

namespace caravan::experiment {
namespace {

using Json = nlohmann::json;

/// The value of `exchanges.completed` is that of `completed` in `exchanges`. @throws Json::exception when it
/// is missing
const Json& value_at(const Json& metrics, std::string_view key) {
  const std::size_t dot = key.find('.');
  const Json& outer = metrics.at(std::string{key.substr(0, dot)});
  return dot == std::string_view::npos ? outer : value_at(outer, key.substr(dot + 1));
}

/// A number; true and null are not numbers. @throws std::runtime_error, Json::exception when it is missing
double number_in(const Json& table, std::string_view key) {
  const Json& value = value_at(table, key);
  if (!value.is_number()) throw std::runtime_error{std::string{key} + " is not a number"};
  return value.get<double>();
}

double claim_in(const Json& table, std::string_view key) {
  const Json& value = value_at(table, key);
  if (!value.is_boolean()) throw std::runtime_error{std::string{key} + " is neither true nor false"};
  return value.get<bool>() ? 1.0 : 0.0;
}

/// The robots' numbers, null if they have none. `metrics` must outlive them. @throws as number_in()
std::vector<RobotNumbers> robots_in(const Json& metrics) {
  const Json& robots = metrics.at("per_robot");
  if (!robots.is_array() || static_cast<double>(robots.size()) != number_in(metrics, "robots"))
    throw std::runtime_error{"per_robot is not a list with one entry per robot"};
  std::vector<RobotNumbers> numbers;
  for (const Json& robot : robots) {
    numbers.emplace_back([&robot](std::string_view key) {
      return value_at(robot, key).is_null() ? std::nullopt : std::optional{number_in(robot, key)};
    });
  }
  return numbers;
}

}  // namespace

const std::vector<Metric>& quantities() {
  static const std::vector<Metric> columns = [] {
    std::vector<Metric> found;
    for (const Metric& metric : metrics_table()) {
      if (!metric.column.empty()) found.push_back(metric);
    }
    return found;
  }();
  return columns;
}

std::vector<std::optional<double>> values_in(const Json& metrics) {
  const std::vector<RobotNumbers> robots = robots_in(metrics);
  std::vector<std::optional<double>> values;
  for (const Metric& metric : quantities()) {
    if (metric.of_robots != nullptr) {
      values.push_back(metric.of_robots(robots));
    } else {
      values.emplace_back(is_yes_or_no(metric) ? claim_in(metrics, metric.key)
                                               : number_in(metrics, metric.key));
    }
  }
  return values;
}

}  // namespace caravan::experiment
