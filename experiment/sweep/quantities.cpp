// SPDX-License-Identifier: Apache-2.0
#include "experiment/sweep/quantities.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace caravan::experiment {
namespace {

using Json = nlohmann::json;
using Value = std::optional<double>;

/// A number, which true and null are not. @throws std::runtime_error, Json::exception when it is missing
double number_in(const Json& table, const char* key) {
  const Json& value = table.at(key);
  if (!value.is_number()) throw std::runtime_error{std::string{key} + " is no number"};
  return value.get<double>();
}

/// False: null. @throws the same
bool has_number(const Json& table, const char* key) {
  return !table.at(key).is_null() && (number_in(table, key), true);
}

/// Entries of the robots, one for each. @throws the same
const Json& robots_in(const Json& metrics) {
  const Json& robots = metrics.at("per_robot");
  if (!robots.is_array() || static_cast<double>(robots.size()) != number_in(metrics, "robots"))
    throw std::runtime_error{"per_robot is no list of one entry for each robot"};
  return robots;
}

/// A run's metrics, and what its robots came to together.
struct Source {
  const Json& metrics;
  double found = 0.0;
  double received = 0.0;
  double without_path = 0.0;
  Value path_length_mean_m;
  double stuck_s = 0.0;
  double longest_stuck_s = 0.0;

  explicit Source(const Json& run) : metrics{run} {
    double length_m = 0.0;
    double paths = 0.0;
    for (const Json& robot : robots_in(metrics)) {
      const bool has_found = has_number(robot, "found_s");
      const bool has_received = has_number(robot, "received_s");
      found += has_found ? 1.0 : 0.0;
      received += has_received ? 1.0 : 0.0;
      without_path += has_found || has_received ? 0.0 : 1.0;
      stuck_s += number_in(robot, "stuck_s");
      longest_stuck_s = std::max(longest_stuck_s, number_in(robot, "longest_stuck_s"));
      if (!has_number(robot, "path_length_m")) continue;
      length_m += number_in(robot, "path_length_m");
      paths += 1.0;
    }
    if (paths > 0.0) path_length_mean_m = length_m / paths;
  }
  [[nodiscard]] double number(const char* key) const { return number_in(metrics, key); }
  [[nodiscard]] double claim(const char* key) const { return metrics.at(key).get<bool>() ? 1.0 : 0.0; }
  [[nodiscard]] double number(const char* table, const char* key) const {
    return number_in(metrics.at(table), key);
  }
};

struct Column {
  Quantity quantity;
  Value (*in)(const Source&);
};

const std::array kColumns = {
    Column{{"completed"}, [](const Source& run) -> Value { return run.claim("completed"); }},
    Column{{"disturbed"}, [](const Source& run) -> Value { return run.claim("disturbed"); }},
    Column{{"items_delivered"}, [](const Source& run) -> Value { return run.number("items_delivered"); }},
    Column{{"sim_time_s"}, [](const Source& run) -> Value { return run.number("sim_time_s"); }},
    Column{{"wall_time_s", false}, [](const Source& run) -> Value { return run.number("wall_time_s"); }},
    Column{{"real_time_factor", false},
           [](const Source& run) -> Value { return run.number("real_time_factor"); }},
    Column{{"round_trip_mean_s"}, [](const Source& run) -> Value { return run.number("round_trip_mean_s"); }},
    Column{{"routes"}, [](const Source& run) -> Value { return run.number("routes"); }},
    Column{{"found"}, [](const Source& run) -> Value { return run.found; }},
    Column{{"received"}, [](const Source& run) -> Value { return run.received; }},
    Column{{"without_path"}, [](const Source& run) -> Value { return run.without_path; }},
    Column{{"path_length_mean_m"}, [](const Source& run) { return run.path_length_mean_m; }},
    Column{{"exchanges_completed"},
           [](const Source& run) -> Value { return run.number("exchanges", "completed"); }},
    Column{{"exchanges_failed"},
           [](const Source& run) -> Value { return run.number("exchanges", "failed"); }},
    Column{{"exchange_mean_s"},
           [](const Source& run) -> Value { return run.number("exchanges", "mean_duration_s"); }},
    Column{{"contacts_robot_robot"},
           [](const Source& run) -> Value { return run.number("contacts", "robot_robot"); }},
    Column{{"contacts_robot_static"},
           [](const Source& run) -> Value { return run.number("contacts", "robot_static"); }},
    Column{{"stuck_s"}, [](const Source& run) -> Value { return run.stuck_s; }},
    Column{{"longest_stuck_s"}, [](const Source& run) -> Value { return run.longest_stuck_s; }}};

}  // namespace

std::span<const Quantity> quantities() {
  static const std::vector<Quantity> all = [] {
    std::vector<Quantity> names;
    for (const Column& column : kColumns) names.push_back(column.quantity);
    return names;
  }();
  return all;
}

std::vector<std::optional<double>> values_in(const Json& metrics) {
  const Source source{metrics};
  std::vector<Value> values;
  for (const Column& column : kColumns) values.push_back(column.in(source));
  return values;
}

}  // namespace caravan::experiment
