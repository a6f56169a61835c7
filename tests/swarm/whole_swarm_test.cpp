// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <fstream>
#include <map>
#include <sstream>

#include "build_paths.hpp"
#include "experiment/embedded/engine.hpp"

namespace caravan::experiment {
namespace {

/// small.toml with some of its text replaced: (old, new) pairs.
runtime::TomlDocument small_with(const std::vector<std::pair<std::string, std::string>>& changes) {
  std::ifstream file{CARAVAN_SOURCE_DIR "/deploy/scenarios/small.toml"};
  std::stringstream whole;
  whole << file.rdbuf();
  std::string text = whole.str();
  for (const auto& [before, after] : changes) {
    const auto at = text.find(before);
    EXPECT_NE(at, std::string::npos) << before;
    if (at != std::string::npos) text.replace(at, before.size(), after);
  }
  return runtime::TomlDocument::parse(text, "small.toml");
}

/// The outcome of a run.
struct Outcome {
  std::uint32_t delivered = 0;
  double time_s = 0.0;
  double longest_stand_s = 0.0;  // longest time of any robot within 0.5 m of one place
  int exchanges_completed = 0;
  int contacts = 0;  // between robots
  std::map<std::uint32_t, std::vector<Place>> paths;
};

void watch_stands(const Observation& seen, std::map<std::uint32_t, std::pair<Place, Time>>& stood,
                  Outcome& outcome) {
  for (const TruePose& pose : seen.poses) {
    const auto [since, is_new] = stood.try_emplace(pose.robot, pose.place, seen.stamp);
    auto& [place, began] = since->second;
    if (std::hypot(pose.place.x_m - place.x_m, pose.place.y_m - place.y_m) > 0.5) {
      place = pose.place;
      began = seen.stamp;
    }
    outcome.longest_stand_s = std::max(outcome.longest_stand_s, in_seconds(seen.stamp - began));
  }
}

Outcome run(const runtime::TomlDocument& scenario) {
  Engine engine{scenario};
  Outcome outcome;
  std::map<std::uint32_t, std::pair<Place, Time>> stood;
  while (!engine.finished()) {
    const Observation& seen = engine.step();
    watch_stands(seen, stood, outcome);
    for (const Contact& contact : seen.contacts) outcome.contacts += contact.other != 0 ? 1 : 0;
    for (const AgentReport& report : seen.agent_reports) {
      if (report.path_changed) outcome.paths[report.robot] = report.path;
      for (const Exchange& exchange : report.exchanges) outcome.exchanges_completed += exchange.completed;
    }
  }
  outcome.delivered = engine.last().items_delivered;
  outcome.time_s = in_seconds(engine.now());
  return outcome;
}

class WholeSwarm : public testing::TestWithParam<const char*> {};

TEST_P(WholeSwarm, DeliversInTheEmulatedWorldWithoutGettingStuck) {
  for (const int seed : {1, 2, 3, 4, 5}) {
    SCOPED_TRACE(seed);
    const Outcome outcome = run(small_with({{"mode = \"full\"", "mode = \"" + std::string{GetParam()} + "\""},
                                            {"seed = 1", "seed = " + std::to_string(seed)},
                                            {"items = 4", "items = 12"}}));
    EXPECT_EQ(outcome.delivered, 12U);
    EXPECT_LE(outcome.contacts, 2);
    EXPECT_LT(outcome.longest_stand_s, 120.0);
    if (std::string{GetParam()} == "none") {
      EXPECT_EQ(outcome.exchanges_completed, 0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, WholeSwarm, testing::Values("none", "partial", "full"));

TEST(WholeSwarmRoutes, MovingAnObstacleChangesTheRoutesAndNothingInTheAgentsTables) {
  const std::pair<std::string, std::string> more_items = {"items = 4", "items = 20"};
  const Outcome here = run(small_with({more_items}));
  const Outcome moved = run(small_with({more_items, {"centre_m = [0.0, 0.0]", "centre_m = [-1.6, 1.6]"}}));
  const auto passes_the_middle = [](const Outcome& outcome) {
    int robots = 0;
    for (const auto& [robot, path] : outcome.paths) {
      bool near = false;
      for (const Place& place : path) near = near || std::hypot(place.x_m, place.y_m) < 0.7;
      robots += near ? 1 : 0;
    }
    return robots;
  };
  EXPECT_EQ(passes_the_middle(here), 0) << "the obstacle stands there";
  EXPECT_GT(passes_the_middle(moved), 0);
}

}  // namespace
}  // namespace caravan::experiment
