// SPDX-License-Identifier: Apache-2.0
#include "experiment/sweep/sweep_tables.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "experiment/metrics/csv_file.hpp"
#include "experiment/metrics/run_directory.hpp"
#include "experiment/sweep/five_numbers.hpp"
#include "experiment/sweep/quantities.hpp"

namespace caravan::experiment {
namespace {

using Json = nlohmann::ordered_json;

/// The shortest text that reads back as the same number.
std::string exact(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string to_text(SweepState state) {
  switch (state) {
    case SweepState::kRunning:
      return "running";
    case SweepState::kUnfinished:
      return "unfinished";
    case SweepState::kComplete:
      return "complete";
  }
  return "";
}

/// Runs that differ by their seeds only: their indices in the plan, in which they follow each other.
struct Group {
  std::size_t begin = 0;
  std::size_t end = 0;
};

std::vector<Group> groups_of(const SweepPlan& plan) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    const bool begins =
        i == 0 || plan.runs[i].mode != plan.runs[i - 1].mode || plan.runs[i].point != plan.runs[i - 1].point;
    if (begins) groups.push_back({i, i});
    groups.back().end = i + 1;
  }
  return groups;
}

/// The values of quantity `column` in the runs of the group that are done.
std::vector<double> sample(std::span<const RunRow> rows, Group group, std::size_t column) {
  std::vector<double> values;
  for (std::size_t i = group.begin; i < group.end; ++i) {
    if (rows[i].state != RunState::kDone) continue;
    if (const auto value = rows[i].values[column]) values.push_back(*value);
  }
  return values;
}

std::size_t column_of(const std::string& name) {
  const auto& all = quantities();
  std::size_t column = 0;
  while (all[column].column != name) ++column;
  return column;
}

std::string padded(const std::string& text, std::size_t width) {
  return std::string(width > text.size() ? width - text.size() : 0, ' ') + text;
}

/// `median (minimum to maximum)` of a quantity.
std::string spread(std::vector<double> values, double unit, int decimals) {
  const auto five = five_numbers(std::move(values));
  if (!five) return "-";
  return fixed(five->median / unit, decimals) + " (" + fixed(five->minimum / unit, decimals) + " to " +
         fixed(five->maximum / unit, decimals) + ")";
}

}  // namespace

std::string sweep_json(const SweepPlan& plan, std::span<const RunRow> rows, SweepState state) {
  Json json = {{"scenario", plan.scenario}, {"engine", plan.engine},   {"modes", plan.modes},
               {"seeds", plan.seeds},       {"state", to_text(state)}, {"runs", Json::array()}};
  if (!plan.axes.empty()) json["axes"] = plan.axes;
  for (const runtime::HashedFile& controller : plan.controllers)
    json["controllers"].push_back({{"file", controller.file}, {"sha256", controller.sha256}});
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    Json run = {{"index", i},
                {"mode", plan.runs[i].mode},
                {"seed", plan.runs[i].seed},
                {"folder", folder_of(plan.runs[i]).string()},
                {"state", to_text(rows[i].state)},
                {"reason", rows[i].reason}};
    if (!plan.axes.empty()) {
      run["point"] = plan.runs[i].point;
      run["values"] = plan.runs[i].values;
    }
    json["runs"].push_back(std::move(run));
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string runs_csv(const SweepPlan& plan, std::span<const RunRow> rows) {
  std::vector<std::string> header = {"index", "mode", "seed"};
  header.insert(header.end(), plan.axes.begin(), plan.axes.end());
  header.insert(header.end(), {"state", "reason", "digest"});
  for (const Metric& quantity : quantities()) header.emplace_back(quantity.column);
  std::string text = csv_row(header);
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    const PlannedRun& run = plan.runs[i];
    std::vector<std::string> fields = {std::to_string(i), run.mode, std::to_string(run.seed)};
    fields.insert(fields.end(), run.values.begin(), run.values.end());
    fields.insert(fields.end(), {to_text(rows[i].state), rows[i].reason, rows[i].digest});
    for (std::size_t column = 0; column < quantities().size(); ++column) {
      const bool known = column < rows[i].values.size() && rows[i].values[column].has_value();
      fields.push_back(known ? exact(*rows[i].values[column]) : "");
    }
    text += csv_row(fields);
  }
  return text;
}

std::string summary_csv(const SweepPlan& plan, std::span<const RunRow> rows) {
  std::vector<std::string> header = {"mode"};
  header.insert(header.end(), plan.axes.begin(), plan.axes.end());
  header.insert(header.end(),
                {"quantity", "n", "minimum", "lower_quartile", "median", "upper_quartile", "maximum"});
  std::string text = csv_row(header);
  for (const Group group : groups_of(plan)) {
    const PlannedRun& run = plan.runs[group.begin];
    for (std::size_t column = 0; column < quantities().size(); ++column) {
      const Metric& quantity = quantities()[column];
      if (!quantity.repeats) continue;
      const auto five = five_numbers(sample(rows, group, column));
      std::vector<std::string> fields = {run.mode};
      fields.insert(fields.end(), run.values.begin(), run.values.end());
      fields.insert(fields.end(), {std::string{quantity.column}, std::to_string(five ? five->n : 0)});
      for (const auto number : {&FiveNumbers::minimum, &FiveNumbers::lower_quartile, &FiveNumbers::median,
                                &FiveNumbers::upper_quartile, &FiveNumbers::maximum}) {
        fields.push_back(five ? exact((*five).*number) : "");
      }
      text += csv_row(fields);
    }
  }
  return text;
}

std::string sweep_table(const SweepPlan& plan, std::span<const RunRow> rows) {
  std::string text = "mode     done  completed  failed  simulated min: median (range)  round trip, min" +
                     std::string{"           routes\n"};
  std::string point;
  for (const Group group : groups_of(plan)) {
    const PlannedRun& run = plan.runs[group.begin];
    if (run.point != point) text += run.point + "\n";
    point = run.point;
    std::size_t done = 0;
    std::size_t failed = 0;
    for (std::size_t i = group.begin; i < group.end; ++i) {
      done += rows[i].state == RunState::kDone ? 1U : 0U;
      failed += rows[i].state == RunState::kFailed ? 1U : 0U;
    }
    double completed = 0.0;
    for (const double one : sample(rows, group, column_of("completed"))) completed += one;
    text += run.mode + std::string(run.mode.size() < 7 ? 7 - run.mode.size() : 0, ' ') +
            padded(std::to_string(done), 6) + padded(fixed(completed, 0), 11) +
            padded(std::to_string(failed), 8) +
            padded(spread(sample(rows, group, column_of("sim_time_s")), 60.0, 1), 31) +
            padded(spread(sample(rows, group, column_of("round_trip_mean_s")), 60.0, 2), 26) +
            padded(spread(sample(rows, group, column_of("routes")), 1.0, 0), 17) + "\n";
  }
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    if (rows[i].state != RunState::kFailed) continue;
    const PlannedRun& run = plan.runs[i];
    text += "failed: " + (run.point.empty() ? "" : run.point + " ") + "mode " + run.mode + " seed " +
            std::to_string(run.seed) + ": " + rows[i].reason + "\n";
  }
  return text;
}

void write_tables(const std::filesystem::path& folder, const SweepPlan& plan, std::span<const RunRow> rows,
                  SweepState state) {
  write_whole_file(folder / "runs.csv", runs_csv(plan, rows));
  write_whole_file(folder / "summary.csv", summary_csv(plan, rows));
  write_whole_file(folder / "sweep.json", sweep_json(plan, rows, state));
}

}  // namespace caravan::experiment
