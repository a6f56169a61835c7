// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/metrics.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "experiment/metrics/metrics_json.hpp"
#include "experiment/metrics/result_table.hpp"
#include "tests/unit/experiment/observations.hpp"

namespace caravan::experiment {
namespace {

using std::chrono::minutes;
using std::chrono::seconds;
using test::at;
using test::doing;
using test::kStep;
using test::with;

AgentReport with_origin(std::uint32_t robot, Origin origin, std::vector<Place> path) {
  AgentReport report = doing(robot, Activity::kDriving);
  report.mode = Mode::kTransport;
  report.origin = origin;
  report.path_changed = true;
  report.path = std::move(path);
  return report;
}

Observation item(Time stamp, ItemEvent::Kind kind, std::uint32_t robot, std::uint32_t delivered) {
  Observation observation = at(stamp, {{0, 0}, {9, 9}});
  observation.item_events = {{.kind = kind, .robot = robot}};
  observation.items_delivered = delivered;
  return observation;
}

TEST(Metrics, ActivitiesAddUpToTheSimulatedTime) {
  Metrics metrics{2};
  for (int i = 0; i <= 5000; ++i) {
    const double x_m = i < 3000 ? 0.02 * i : 60.0;
    Observation observation = at(i * kStep, {{x_m, 0.0}, {0.0, 0.7 * (i % 2000)}});
    if (i == 10) observation = with(observation, doing(1, Activity::kDriving));
    if (i == 700) observation = with(observation, doing(1, Activity::kExchanging));
    if (i == 720) observation = with(observation, doing(1, Activity::kAvoiding));
    metrics.observe(observation);
  }

  const Result result = metrics.result();

  EXPECT_EQ(result.sim_time, 5000 * kStep);
  for (const RobotResult& robot : result.robots) {
    const ActivityTimes& times = robot.times;
    EXPECT_EQ(times.driving + times.exchanging + times.avoiding + times.stuck + times.idle, result.sim_time);
  }
  EXPECT_GT(result.robots[0].times.stuck, minutes{1});
  EXPECT_EQ(result.robots[0].times.exchanging, 20 * kStep);
  EXPECT_EQ(result.robots[1].times.idle, result.sim_time);
}

TEST(Metrics, TheFirstOriginOfAPathCountsAndNoLaterOne) {
  Metrics metrics{2};
  metrics.observe(at(seconds{0}, {{0, 0}, {1, 1}}));
  metrics.observe(with(at(seconds{10}, {{0, 0}, {1, 1}}), with_origin(1, Origin::kFound, {{0, 0}, {3, 4}})));
  metrics.observe(
      with(at(seconds{20}, {{0, 0}, {1, 1}}), with_origin(1, Origin::kReceived, {{0, 0}, {3, 0}})));
  metrics.observe(
      with(at(seconds{30}, {{0, 0}, {1, 1}}), with_origin(2, Origin::kReceived, {{0, 0}, {0, 9}})));

  const Result result = metrics.result();

  EXPECT_EQ(result.robots[0].found, seconds{10});
  EXPECT_EQ(result.robots[0].received, std::nullopt);
  EXPECT_EQ(result.robots[1].found, std::nullopt);
  EXPECT_EQ(result.robots[1].received, seconds{30});
  EXPECT_EQ(result.robots[0].path_length_m, 3.0);
  EXPECT_EQ(result.routes, 2U);
  EXPECT_EQ(metrics.progress().robots_with_path, 2U);
}

TEST(Metrics, ARobotWithoutPathHasNoPathLength) {
  Metrics metrics{1};
  metrics.observe(at(seconds{1}, {{0, 0}}));

  EXPECT_EQ(metrics.result().robots[0].path_length_m, std::nullopt);
}

TEST(Metrics, RoundTripsRunFromPickUpToTheNextPickUpOfTheSameRobot) {
  Metrics metrics{2};
  metrics.observe(item(seconds{100}, ItemEvent::Kind::kPickUp, 1, 0));
  metrics.observe(item(seconds{110}, ItemEvent::Kind::kPickUp, 2, 0));
  metrics.observe(item(seconds{200}, ItemEvent::Kind::kDelivery, 1, 1));
  metrics.observe(item(seconds{300}, ItemEvent::Kind::kPickUp, 1, 1));
  metrics.observe(item(seconds{510}, ItemEvent::Kind::kPickUp, 2, 1));

  const Result result = metrics.result();

  EXPECT_DOUBLE_EQ(result.round_trip_mean_s, 300.0);  // the mean of 200 and 400
  EXPECT_EQ(result.items_delivered, 1U);
  EXPECT_EQ(result.robots[0].items, 1U);
  EXPECT_EQ(result.robots[1].items, 0U);
}

TEST(Metrics, AContactOfTwoRobotsCountsOnceThoughBothSidesTellIt) {
  Metrics metrics{3};
  Observation observation = at(seconds{1}, {{0, 0}, {0, 1}, {5, 5}});
  observation.contacts = {{.robot = 1, .other = 2}, {.robot = 2, .other = 1}, {.robot = 3, .other = 0}};
  metrics.observe(observation);
  observation.stamp = seconds{9};
  observation.contacts = {{.robot = 1, .other = 2}};
  metrics.observe(observation);

  EXPECT_EQ(metrics.result().robot_robot_contacts, 2U);
  EXPECT_EQ(metrics.result().robot_static_contacts, 1U);
}

TEST(Metrics, ReportsOfRobotsThatDoNotExistAreIgnored) {
  Metrics metrics{1};
  metrics.observe(with(at(seconds{1}, {{0, 0}, {3, 3}}), doing(77, Activity::kDriving)));
  metrics.observe(item(seconds{2}, ItemEvent::Kind::kDelivery, 77, 1));

  EXPECT_EQ(metrics.result().robots.size(), 1U);
}

TEST(Metrics, AddsUpTheMalformedFramesThatEachRobotHasHeardSoFar) {
  Metrics metrics{2};
  AgentReport first = doing(1, Activity::kDriving);
  AgentReport second = doing(2, Activity::kDriving);
  first.malformed_frames = 3;
  second.malformed_frames = 1;
  metrics.observe(with(with(at(seconds{1}, {{0, 0}, {1, 1}}), first), second));
  first.malformed_frames = 5;
  metrics.observe(with(at(seconds{2}, {{0, 0}, {1, 1}}), first));

  EXPECT_EQ(metrics.result().malformed_frames, 6U);
}

RunFacts facts_of(std::uint32_t items) {
  return {.scenario = "small",
          .engine = "embedded",
          .mode = "full",
          .seed = 7,
          .robots = 2,
          .items = items,
          .max_time = minutes{120}};
}

/// All keys; a key inside another is `outer.inner`. A list of objects contributes the keys of all its
/// objects.
std::set<std::string> keys_of(const nlohmann::json& value, const std::string& outer = "") {
  std::set<std::string> keys;
  for (const auto& [key, inner] : value.items()) {
    const std::string name = value.is_array() ? outer : outer.empty() ? key : outer + "." + key;
    keys.insert(name);
    if (inner.is_structured()) keys.merge(keys_of(inner, name));
  }
  return keys;
}

TEST(MetricsJson, HasExactlyTheKeysThatToolsRelyOnAndThoseAddedSince) {
  Metrics metrics{2};
  metrics.observe(with(at(seconds{10}, {{0, 0}, {1, 1}}), with_origin(1, Origin::kFound, {{0, 0}, {3, 4}})));
  RunEnd end;
  end.digest = "0123456789abcdef";
  end.wall_time_s = 2.5;
  end.refusals.frames_lost = 17;

  const std::string text = metrics_json(facts_of(4), metrics.result(), end);

  auto json = nlohmann::json::parse(text);
  EXPECT_EQ(json.erase("provenance"), 1U);  // the tests of ProvenanceJson have its keys
  EXPECT_THAT(keys_of(json),
              testing::UnorderedElementsAre(
                  "scenario", "engine", "controller", "mode", "seed", "robots", "ended", "completed",
                  "disturbed", "interrupted", "failure", "items_delivered", "sim_time_s", "wall_time_s",
                  "real_time_factor", "digest", "round_trip_mean_s", "routes", "exchanges",
                  "exchanges.completed", "exchanges.failed", "exchanges.mean_duration_s", "contacts",
                  "contacts.robot_robot", "contacts.robot_static", "commands", "commands.refused",
                  "commands.clamped", "frames", "frames.over_mtu", "frames.bad_channel", "frames.lost",
                  "frames.queue_full", "frames.malformed", "per_robot", "per_robot.id", "per_robot.found_s",
                  "per_robot.received_s", "per_robot.items", "per_robot.path_length_m", "per_robot.driving_s",
                  "per_robot.exchanging_s", "per_robot.avoiding_s", "per_robot.stuck_s", "per_robot.idle_s",
                  "per_robot.longest_stuck_s", "time_split", "time_split.physics", "time_split.sensors",
                  "time_split.radio", "time_split.agents", "time_split.transport", "strangers"));
  EXPECT_THAT(text, testing::HasSubstr("\"found_s\": 10.0"));
  EXPECT_THAT(text, testing::HasSubstr("\"found_s\": null"));
  EXPECT_THAT(text, testing::HasSubstr("\"real_time_factor\": 4.0"));
  EXPECT_THAT(text, testing::HasSubstr("\"path_length_m\": 5.0"));
  EXPECT_THAT(text, testing::HasSubstr("\"lost\": 17"));
}

TEST(Outcome, SaysHowARunEndedAndWhatToExitWith) {
  const auto code = [](const RunFacts& facts, const RunEnd& end, std::uint32_t delivered, Time time) {
    return exit_code_of(outcome_of(facts, end, delivered, time));
  };
  RunEnd interrupted;
  interrupted.interrupted = true;
  RunEnd failed;
  failed.failure = "the world server died";

  EXPECT_EQ(code(facts_of(4), {}, 4, minutes{20}), 0);
  EXPECT_EQ(code(facts_of(4), {}, 3, minutes{120}), 1);
  EXPECT_EQ(code(facts_of(0), {}, 0, minutes{120}), 0);
  EXPECT_EQ(code(facts_of(4), interrupted, 3, minutes{20}), 130);
  EXPECT_EQ(code(facts_of(4), failed, 4, minutes{20}), 1);
}

TEST(ResultTable, FitsInAHundredColumnsWithLargeNumbers) {
  Metrics metrics{150};
  metrics.observe(
      with(at(minutes{9999}, {{0, 0}}), with_origin(100, Origin::kFound, {{0, 0}, {3000, 4000}})));
  RunFacts facts = facts_of(100);
  facts.seed = 1234567890;
  RunEnd end;
  end.wall_time_s = 12345.6;

  const std::string table = result_table(facts, metrics.result(), end);

  std::istringstream lines{table};
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
  EXPECT_THAT(table, testing::HasSubstr("1 found, 0 received, 149 without"));
}

}  // namespace
}  // namespace caravan::experiment
