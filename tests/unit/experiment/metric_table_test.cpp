// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/metric_table.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "build_paths.hpp"

namespace caravan::experiment {
namespace {

std::string text_of(const std::string& file) {
  std::ifstream in{std::string{CARAVAN_SOURCE_DIR} + "/" + file};
  return {std::istreambuf_iterator<char>{in}, {}};
}

std::string row(std::string_view name, std::string_view unit, const std::string& meaning) {
  return "| `" + std::string{name} + "` | " + (unit.empty() ? "-" : std::string{unit}) + " | " + meaning +
         " |\n";
}

/// The rows as docs/outputs.md must have them.
std::string table_of_json() {
  std::string text;
  for (const Metric& metric : metrics_table()) {
    if (!metric.key.empty()) text += row(metric.key, metric.unit, std::string{metric.meaning});
  }
  return text;
}

std::string table_of_robots() {
  std::string text;
  for (const RobotMetric& metric : robot_metrics())
    text += row(metric.key, metric.unit, std::string{metric.meaning});
  return text;
}

std::string table_of_columns() {
  std::string text;
  for (const Metric& metric : metrics_table()) {
    if (metric.column.empty()) continue;
    const std::string as = "`" + std::string{metric.key} + "` of `metrics.json`";
    const std::string claim = is_yes_or_no(metric) ? ": 1 or 0" : "";
    text += row(metric.column, metric.unit, metric.key.empty() ? std::string{metric.meaning} : as + claim);
  }
  return text;
}

/// The rows of the first table after `heading`.
std::string table_behind(const std::string& text, const std::string& heading) {
  const std::size_t begin = text.find("|---|", text.find(heading));
  const std::size_t first = text.find('\n', begin) + 1;
  return text.substr(first, text.find("\n\n", first) + 1 - first);
}

TEST(MetricTable, IsWhatTheDocumentationSays) {
  const std::string outputs = text_of("docs/outputs.md");
  EXPECT_EQ(table_behind(outputs, "\n## metrics.json\n"), table_of_json());
  EXPECT_EQ(table_behind(outputs, "\n`per_robot`, one for each robot"), table_of_robots());
  EXPECT_EQ(table_behind(outputs, "\n### runs.csv\n"), table_of_columns());
}

TEST(MetricTable, HasEveryKeyThatTheReportReads) {
  const std::string records = text_of("experiment/report/records.py");
  const std::size_t begin = records.find("\nMETRICS = {");
  const std::string kinds = records.substr(begin, records.find("\nclass ", begin) - begin);
  std::set<std::string> known;
  for (const Metric& metric : metrics_table()) {
    known.emplace(metric.key.substr(0, metric.key.find('.')));
    known.emplace(metric.key.substr(metric.key.find('.') + 1));
  }
  for (const RobotMetric& metric : robot_metrics()) known.emplace(metric.key);
  const std::regex key{"\"([a-z_]+)\": "};
  std::size_t count = 0;
  for (std::sregex_iterator found{kinds.begin(), kinds.end(), key}, end; found != end; ++found, ++count)
    EXPECT_TRUE(known.contains((*found)[1])) << (*found)[1];
  EXPECT_GT(count, 20U);
}

TEST(MetricTable, HasEachNameOnceAndOneValueForIt) {
  std::set<std::string_view> keys;
  std::set<std::string_view> columns;
  for (const Metric& metric : metrics_table()) {
    EXPECT_TRUE(metric.key.empty() || keys.insert(metric.key).second) << metric.key;
    EXPECT_TRUE(metric.column.empty() || columns.insert(metric.column).second) << metric.column;
    EXPECT_EQ((metric.of_run == nullptr ? 0 : 1) + (metric.of_robots == nullptr ? 0 : 1),
              metric.key == "per_robot" ? 0 : 1)
        << metric.key;
    EXPECT_FALSE(metric.meaning.empty()) << metric.key;
  }
  std::set<std::string_view> of_robots;
  for (const RobotMetric& metric : robot_metrics())
    EXPECT_TRUE(of_robots.insert(metric.key).second && metric.value != nullptr) << metric.key;
}

TEST(MetricTable, CountsRobotsByHowTheyGotTheirPath) {
  Result result;
  result.robots = {
      {.id = 1, .found = Time{1}, .received = {}, .items = 1, .path_length_m = 10.0, .times = {}},
      {.id = 2, .found = {}, .received = Time{2}, .items = 1, .path_length_m = 20.0, .times = {}},
      {.id = 3, .found = {}, .received = {}, .items = 0, .path_length_m = {}, .times = {}}};
  result.robots[2].times.stuck = std::chrono::seconds{70};
  const auto value = [&](std::string_view column) {
    const auto found = std::ranges::find(metrics_table(), column, &Metric::column);
    return found->of_robots(numbers_of_robots(result)).value_or(-1.0);
  };

  EXPECT_EQ(value("found"), 1.0);
  EXPECT_EQ(value("received"), 1.0);
  EXPECT_EQ(value("without_path"), 1.0);
  EXPECT_EQ(value("path_length_mean_m"), 15.0);
  EXPECT_EQ(value("stuck_s"), 70.0);
  result.robots.clear();
  EXPECT_EQ(value("path_length_mean_m"), -1.0) << "without a path there is no mean";
}

}  // namespace
}  // namespace caravan::experiment
