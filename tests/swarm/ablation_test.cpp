// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>

#include "experiment/embedded/engine.hpp"

namespace caravan::experiment {
namespace {

/// The small scenario with more items; robots that are solid or not, and that stop for an exchange or not.
runtime::TomlDocument small(bool solid, bool stop, int seed) {
  const auto text = [](bool value) { return std::string{value ? "true" : "false"}; };
  return runtime::TomlDocument::parse("seed = " + std::to_string(seed) +
                                          "\n"
                                          "[robots]\ncount = 4\nsource_m = [-4.5, -4.5]\n"
                                          "destination_m = [4.5, 4.5]\nsolid = " +
                                          text(solid) +
                                          "\n[algorithm]\nmode = \"full\"\nsharing_starts_s = 60.0\n"
                                          "recontact_after_s = 60.0\nstop_to_exchange = " +
                                          text(stop) +
                                          "\n[experiment]\nitems = 12\nmax_time_s = 3600.0\n"
                                          "[world]\narena_m = [12.0, 12.0]\nstart_low_m = [-5.4, -5.4]\n"
                                          "start_high_m = [-2.8, -2.8]\n"
                                          "[[world.box]]\ncentre_m = [0.0, 0.0]\nsize_m = [3.0, 2.0]\n"
                                          "yaw_rad = -0.7853981633974483\n",
                                      "small.toml");
}

struct Outcome {
  std::uint32_t delivered = 0;
  int exchanges_completed = 0;
  int reports_of_exchanging = 0;
  int contacts = 0;
  double closest_m = 1e9;  // distance of any two robots
};

Outcome run(const runtime::TomlDocument& scenario) {
  Engine engine{scenario};
  Outcome outcome;
  while (!engine.finished()) {
    const Observation& seen = engine.step();
    for (const Contact& contact : seen.contacts) outcome.contacts += contact.other == 0 ? 0 : 1;
    for (const AgentReport& report : seen.agent_reports) {
      outcome.reports_of_exchanging += report.activity == Activity::kExchanging ? 1 : 0;
      for (const Exchange& exchange : report.exchanges) outcome.exchanges_completed += exchange.completed;
    }
    for (const TruePose& one : seen.poses) {
      for (const TruePose& other : seen.poses) {
        if (other.robot <= one.robot) continue;
        const double apart_m = std::hypot(one.place.x_m - other.place.x_m, one.place.y_m - other.place.y_m);
        outcome.closest_m = std::min(outcome.closest_m, apart_m);
      }
    }
  }
  outcome.delivered = engine.last().items_delivered;
  return outcome;
}

class Ablation : public testing::TestWithParam<int> {};

TEST_P(Ablation, RobotsThatAreNotSolidPassThroughOneAnotherAndDeliver) {
  const Outcome solid = run(small(true, true, GetParam()));
  const Outcome ghosts = run(small(false, true, GetParam()));

  EXPECT_EQ(ghosts.delivered, 12U);
  EXPECT_EQ(ghosts.contacts, 0);
  EXPECT_LT(ghosts.closest_m, 0.2) << "two of them never were in one place";
  EXPECT_GT(solid.closest_m, 0.3) << "bodies are 0.381 m wide";
  EXPECT_GT(ghosts.exchanges_completed, 0) << "they still hear one another";
}

TEST_P(Ablation, RobotsThatDoNotStopToExchangeExchangeAllTheSame) {
  const Outcome stopping = run(small(true, true, GetParam()));
  const Outcome driving = run(small(true, false, GetParam()));

  EXPECT_GT(stopping.reports_of_exchanging, 0);
  EXPECT_EQ(driving.reports_of_exchanging, 0);
  EXPECT_GT(driving.exchanges_completed, 0);
  EXPECT_EQ(driving.delivered, 12U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Ablation, testing::Values(1, 2, 3));

}  // namespace
}  // namespace caravan::experiment
