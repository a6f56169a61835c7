// SPDX-License-Identifier: Apache-2.0
// The controllers in deploy/controllers do what their pages say.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "build_paths.hpp"
#include "experiment/embedded/engine.hpp"

namespace caravan::experiment {
namespace {

/// A scenario of deploy/scenarios, driven by an example. `changes` are (old, new) pairs of text.
runtime::TomlDocument scenario_with(const std::string& name, const std::string& controller,
                                    const std::vector<std::pair<std::string, std::string>>& changes) {
  std::ifstream file{std::string{CARAVAN_SOURCE_DIR} + "/deploy/scenarios/" + name};
  std::stringstream whole;
  whole << file.rdbuf();
  std::string text = whole.str();
  for (const auto& [before, after] : changes) {
    const auto at = text.find(before);
    EXPECT_NE(at, std::string::npos) << before;
    if (at != std::string::npos) text.replace(at, before.size(), after);
  }
  const auto library =
      std::filesystem::path{CARAVAN_BIN_DIR}.parent_path() / "controllers" / (controller + ".so");
  return runtime::TomlDocument::parse(text + "\n[controller]\nlibrary = \"" + library.string() + "\"\n",
                                      name);
}

/// |mean of the headings' unit vectors|: 1 when all robots look in one direction.
double polarisation(const Observation& seen) {
  std::complex<double> sum;
  for (const TruePose& pose : seen.poses) sum += std::polar(1.0, pose.yaw_rad);
  return std::abs(sum) / static_cast<double>(seen.poses.size());
}

/// Robots of the largest group, within which a chain of distances up to the radio's range connects all.
std::size_t largest_group(const Observation& seen) {
  std::vector<Place> left;
  for (const TruePose& pose : seen.poses) left.push_back(pose.place);
  std::size_t largest = 0;
  while (!left.empty()) {
    std::vector<Place> group{left.back()};
    left.pop_back();
    for (std::size_t i = 0; i < group.size(); ++i) {
      const Place at = group[i];
      const auto near = [at](const Place& other) {
        return std::hypot(other.x_m - at.x_m, other.y_m - at.y_m) <= 2.0;
      };
      for (const Place& other : left) {
        if (near(other)) group.push_back(other);
      }
      std::erase_if(left, near);
    }
    largest = std::max(largest, group.size());
  }
  return largest;
}

struct Flight {
  double polarisation = 0.0;  // mean of the second minute
  std::size_t largest_group = 0;
};

Flight fly(const std::string& radio, int seed) {
  Engine engine{scenario_with("flocking.toml", "flocking",
                              {{"seed = 1", "seed = " + std::to_string(seed)},
                               {"[radio]\n", "[radio]\n" + radio},
                               {"max_time_s = 300.0", "max_time_s = 120.0"}})};
  Flight flight;
  int steps = 0;
  while (!engine.finished()) {
    const Observation& seen = engine.step();
    if (in_seconds(seen.stamp) < 60.0) continue;
    flight.polarisation += polarisation(seen);
    ++steps;
  }
  flight.polarisation /= steps;
  flight.largest_group = largest_group(engine.last());
  return flight;
}

TEST(Flocking, TurnsRobotsInOneDirectionAndKeepsThemTogetherWithTheRadioOnly) {
  for (const int seed : {1, 2, 3}) {
    SCOPED_TRACE(seed);
    const Flight with_radio = fly("", seed);
    EXPECT_GT(with_radio.polarisation, 0.65);
    EXPECT_GE(with_radio.largest_group, 12U);
    const Flight without = fly("loss_probability = 1.0\n", seed);
    EXPECT_LT(without.polarisation, 0.35);
    EXPECT_LE(without.largest_group, 8U);
  }
}

TEST(Braitenberg, WandersAndTouchesNoWall) {
  Engine engine{scenario_with("small.toml", "braitenberg",
                              {{"items = 4", "items = 0"}, {"max_time_s = 3600.0", "max_time_s = 60.0"}})};
  std::vector<Place> before;
  std::vector<double> driven_m;
  int touches = 0;
  while (!engine.finished()) {
    const Observation& seen = engine.step();
    driven_m.resize(seen.poses.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      driven_m[i] +=
          std::hypot(seen.poses[i].place.x_m - before[i].x_m, seen.poses[i].place.y_m - before[i].y_m);
    }
    before.clear();
    for (const TruePose& pose : seen.poses) before.push_back(pose.place);
    for (const Contact& contact : seen.contacts) touches += contact.other == 0 ? 1 : 0;
  }
  EXPECT_EQ(touches, 0);
  std::sort(driven_m.begin(), driven_m.end());
  EXPECT_GT(driven_m[1], 15.0) << "of four robots, three wander; one may be held up in a corner";
}

}  // namespace
}  // namespace caravan::experiment
