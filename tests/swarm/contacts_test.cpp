// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "experiment/embedded/engine.hpp"

namespace caravan::experiment {
namespace {

/// Six robots in the room of small.toml, which is narrow for six: they turn and give way beside walls.
runtime::TomlDocument narrow(int seed, int items, const std::string& algorithm) {
  return runtime::TomlDocument::parse("seed = " + std::to_string(seed) +
                                          "\n[robots]\ncount = 6\nsource_m = [-4.5, -4.5]\n"
                                          "destination_m = [4.5, 4.5]\n"
                                          "[algorithm]\nmode = \"full\"\nsharing_starts_s = 60.0\n"
                                          "recontact_after_s = 120.0\n" +
                                          algorithm + "[experiment]\nitems = " + std::to_string(items) +
                                          "\nmax_time_s = 3600.0\n"
                                          "[world]\narena_m = [12.0, 12.0]\nstart_low_m = [-5.4, -5.4]\n"
                                          "start_high_m = [-2.8, -2.8]\n"
                                          "[[world.box]]\ncentre_m = [0.0, 0.0]\nsize_m = [3.0, 2.0]\n"
                                          "yaw_rad = -0.7853981633974483\n"
                                          "[[world.cylinder]]\ncentre_m = [2.8, -2.4]\nradius_m = 0.6\n",
                                      "narrow.toml");
}

struct Outcome {
  bool finished_in_time = false;
  int with_static = 0;
  int between_robots = 0;
};

Outcome run(const runtime::TomlDocument& scenario, int items) {
  Engine engine{scenario};
  Outcome outcome;
  while (!engine.finished()) {
    for (const Contact& contact : engine.step().contacts) {
      ++(contact.other == 0 ? outcome.with_static : outcome.between_robots);
    }
  }
  outcome.finished_in_time = engine.last().items_delivered == static_cast<std::uint32_t>(items);
  return outcome;
}

// Contacts of each seed without seen.surfaces: 24, 23.
TEST(Contacts, RobotsThatTurnAndGiveWayBesideWallsSeldomTouchThem) {
  int contacts = 0;
  for (const int seed : {1, 2}) {
    SCOPED_TRACE(seed);
    const Outcome outcome = run(narrow(seed, 40, ""), 40);
    EXPECT_TRUE(outcome.finished_in_time);
    contacts += outcome.with_static;
  }
  EXPECT_LE(contacts, 15);
}

// Contacts of each seed with one WAIT a second and none between: 3, 4, 8.
TEST(Contacts, RobotsWhoseWaitsAreRareSeldomTouchEachOther) {
  int contacts = 0;
  for (const int seed : {1, 2, 3}) {
    SCOPED_TRACE(seed);
    const Outcome outcome = run(narrow(seed, 15, "wait_period_s = 1.0\n"), 15);
    EXPECT_TRUE(outcome.finished_in_time);
    contacts += outcome.between_robots;
  }
  EXPECT_LE(contacts, 5);
}

}  // namespace
}  // namespace caravan::experiment
