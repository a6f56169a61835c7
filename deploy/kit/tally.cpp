// SPDX-License-Identifier: Apache-2.0
#include "deploy/kit/tally.hpp"

#include "experiment/metrics/metric_table.hpp"
#include "runtime/pure/overload.hpp"

namespace caravan::deploy {
namespace {

using experiment::About;
using experiment::MetricValue;

/// Converts to text, number or yes and no; none: null, or a list.
std::optional<Tally::Number> to_number(const MetricValue& value) {
  using Number = std::optional<Tally::Number>;
  return std::visit(pure::Overload{[](double number) { return Number{number}; },
                                   [](std::uint64_t count) { return Number{static_cast<double>(count)}; },
                                   [](bool claim) { return Number{claim ? "yes" : "no"}; },
                                   [](const std::string& word) { return Number{word}; },
                                   [](std::monostate) { return Number{}; },
                                   [](const std::vector<std::string>&) { return Number{}; }},
                    value);
}

/// The others are excluded: those that repeat the scenario, and those that only the end of a run decides.
MetricKeys make_keys() {
  MetricKeys keys;
  for (const experiment::Metric& metric : experiment::metrics_table()) {
    if (!metric.key.empty() && metric.about == About::kResult) keys.of_run.emplace(metric.key);
  }
  for (const experiment::RobotMetric& metric : experiment::robot_metrics()) {
    if (metric.key != "id") keys.of_robot.emplace(metric.key);
  }
  return keys;
}

}  // namespace

Tally::Tally(experiment::RunFacts facts)
    : facts_{std::move(facts)}, metrics_{facts_.robots}, book_{facts_.robots} {}

void Tally::observe(const experiment::Observation& observation) {
  const std::lock_guard lock{mutex_};
  metrics_.observe(observation);
  result_.reset();
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
  if (!result_) result_ = metrics_.result();
  if (robot == 0) {
    const experiment::Metric* metric = experiment::find_metric(key);
    return metric == nullptr ? std::nullopt : to_number(metric->of_run({facts_, *result_, end_, false}));
  }
  const experiment::RobotMetric* metric = experiment::find_robot_metric(key);
  if (metric == nullptr || robot > result_->robots.size()) return std::nullopt;
  return to_number(metric->value(result_->robots[robot - 1]));
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
  static const MetricKeys keys = make_keys();
  return keys;
}

}  // namespace caravan::deploy
