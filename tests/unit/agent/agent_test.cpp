// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/agent.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <set>
#include <string>

#include "robot_agent/core/angle.hpp"
#include "robot_agent/core/path/path.hpp"
#include "runtime/pure/random.hpp"
#include "tests/support/line_world.hpp"

namespace caravan::agent {
namespace {

using namespace std::chrono_literals;
using test::LineWorld;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A room of 12 m with a box in it; the destination is out of sight from the source.
Config room() {
  Config config;
  config.task.source = {-4.5, -4.5};
  config.task.destination = {4.5, 4.5};
  config.sharing.mode = Sharing::kNone;
  return config;
}
LineWorld world_of(const Config& config) {
  LineWorld world{config};
  world.add_walls(test::rectangle({0, 0}, 12, 12));
  world.add_walls(test::rectangle({0, 0}, 3, 2, -0.785));
  return world;
}

/// The inputs and outputs of a robot on a drive through the room.
struct Drive {
  std::vector<Inputs> inputs;
  std::vector<Outputs> outputs;
};
Drive drive(const Config& config, int steps) {
  LineWorld world = world_of(config);
  world.add_robot({-4.0, -4.0}, 0.7);
  Drive result;
  for (int i = 0; i < steps; ++i) {
    result.inputs.push_back({i * 32ms, world.sense(0), {}});
    world.step();
    result.outputs.push_back(world.outputs(0));
  }
  return result;
}

TEST(Agent, RecordedSensorsGiveTheSameCommandsAgain) {
  const Drive recorded = drive(room(), 5000);
  Config config = room();
  config.id = RobotId{1};
  Agent agent{config};
  for (std::size_t i = 0; i < recorded.inputs.size(); ++i) {
    const Outputs again = agent.step(recorded.inputs[i]);
    ASSERT_EQ(again.wheels, recorded.outputs[i].wheels) << "step " << i;
    ASSERT_EQ(again.gripper_closed, recorded.outputs[i].gripper_closed) << "step " << i;
    ASSERT_EQ(again.frames, recorded.outputs[i].frames) << "step " << i;
  }
}

TEST(Agent, TheDestinationHasNoInfluenceUntilItIsInSight) {
  const Drive recorded = drive(room(), 12000);
  Config here = room();
  Config elsewhere = room();
  elsewhere.task.destination = {-300.0, 7000.0};
  Agent one{here};
  Agent other{elsewhere};
  bool in_sight = false;
  int equal_steps = 0;
  for (const Inputs& inputs : recorded.inputs) {
    const Wheels first = one.step(inputs).wheels;
    const Wheels second = other.step(inputs).wheels;
    in_sight = in_sight ||
               (inputs.sensors.p_WB - here.task.destination).norm() <= here.exploration.detection_radius_m;
    if (in_sight) break;
    ASSERT_EQ(first, second);
    ++equal_steps;
  }
  EXPECT_TRUE(in_sight) << "the drive was too short to test anything";
  EXPECT_GT(equal_steps, 100);
}

TEST(Agent, WithoutPositionOrHeadingItStopsAndGoesOnWhenTheyAreBack) {
  Agent agent{room()};
  Sensors open;
  open.sonar_range_m.fill(std::numeric_limits<double>::infinity());
  EXPECT_NE(agent.step({0ms, open, {}}).wheels, Wheels{});
  Sensors lost = open;
  lost.p_WB.x() = kNan;
  const Outputs stopped = agent.step({32ms, lost, {}});
  EXPECT_EQ(stopped.wheels, Wheels{});
  EXPECT_EQ(stopped.report.activity, Activity::kIdle);
  EXPECT_FALSE(stopped.frames.empty()) << "others must hear that it is there";
  lost = open;
  lost.yaw_WB_rad = kNan;
  EXPECT_EQ(agent.step({64ms, lost, {}}).wheels, Wheels{});
  EXPECT_NE(agent.step({96ms, open, {}}).wheels, Wheels{});
}

TEST(Agent, WithoutSonarsItStops) {
  Agent agent{room()};
  Sensors blind;
  blind.sonar_range_m.fill(kNan);
  EXPECT_EQ(agent.step({0ms, blind, {}}).wheels, Wheels{});
}

/// Whether the agent avoids anything on its approach to the destination, with a wall beyond it, when it
/// receives the frames of another robot.
bool gives_way(bool robots_are_solid) {
  Config config;
  config.id = RobotId{2};
  config.task.destination = {2.0, 0.0};
  config.task.service_radius_m = config.task.arrival_radius_m = 0.3;
  config.robots_are_solid = robots_are_solid;
  Agent agent{config};
  Agent other{Config{}};
  Sensors sensors;
  for (int i = 0; i < 200; ++i) {
    sensors.sonar_range_m.fill(std::numeric_limits<double>::infinity());
    for (const std::size_t front : {3U, 4U}) sensors.sonar_range_m[front] = 2.7 - sensors.p_WB.x();
    std::vector<ReceivedFrame> heard;
    for (Frame& frame : other.step({i * 32ms, sensors, {}}).frames) {
      heard.push_back({.channel = frame.channel, .bytes = std::move(frame.bytes)});
    }
    const Outputs outputs = agent.step({i * 32ms, sensors, heard});
    if (outputs.report.activity == Activity::kAvoiding) return true;
    if (outputs.report.mode == Mode::kTransport) return false;
    sensors.p_WB.x() += 0.016 * (outputs.wheels.left_mps + outputs.wheels.right_mps);
  }
  ADD_FAILURE() << "never came to the destination";
  return false;
}

TEST(Agent, GivesWayToSomethingAheadWhenItHearsARobotUnlessRobotsAreNotSolid) {
  EXPECT_TRUE(gives_way(true));
  EXPECT_FALSE(gives_way(false));
}

TEST(Agent, SaysItIsThereInEveryStepOnTheCommonChannel) {
  const Drive recorded = drive(room(), 100);
  for (const Outputs& outputs : recorded.outputs) {
    ASSERT_FALSE(outputs.frames.empty());
    EXPECT_EQ(outputs.frames.front().channel, kCommonChannel);
  }
}

/// Whether a report contains anything new since the one before it.
bool is_news(const Report& before, const Report& now) {
  return now.mode != before.mode || now.activity != before.activity || now.origin != before.origin ||
         now.towards_destination != before.towards_destination || now.trips != before.trips ||
         now.malformed_frames != before.malformed_frames || now.path_changed || !now.exchanges.empty() ||
         !now.events.empty();
}

TEST(Agent, ReportsItsFirstStepAndThenTheStepsThatHaveNewsAndNoOthers) {
  const Drive recorded = drive(room(), 12000);
  int reports = 0;
  std::set<std::string> events;
  for (std::size_t i = 0; i < recorded.outputs.size(); ++i) {
    const Outputs& now = recorded.outputs[i];
    ASSERT_EQ(now.reports, i == 0 || is_news(recorded.outputs[i - 1].report, now.report)) << "step " << i;
    reports += now.reports ? 1 : 0;
    for (const Event& event : now.report.events) events.insert(event.name);
  }
  EXPECT_LT(reports, 4000) << "most steps have none";
  EXPECT_TRUE(events.contains("found_path")) << "the drive was too short to test anything";
}

TEST(Agent, ReportsWhatIsSentToItThatIsNotOfTheProtocolOnce) {
  Agent agent{room()};
  Sensors open;
  open.sonar_range_m.fill(std::numeric_limits<double>::infinity());
  EXPECT_TRUE(agent.step({0ms, open, {}}).reports);
  EXPECT_FALSE(agent.step({32ms, open, {}}).reports);
  const Outputs hearing = agent.step({64ms, open, {{.channel = kCommonChannel, .bytes = {0xff}}}});
  EXPECT_TRUE(hearing.reports);
  EXPECT_EQ(hearing.report.malformed_frames, 1U);
  EXPECT_FALSE(agent.step({96ms, open, {}}).reports);
}

TEST(Agent, FindsTheDestinationDrivesBackAndThenCarries) {
  LineWorld world = world_of(room());
  world.add_robot({-4.0, -4.0}, 0.7);
  while (world.count(0, "found_path") == 0 && world.now_s() < 1200.0) world.step();
  ASSERT_EQ(world.count(0, "found_path"), 1);
  EXPECT_FALSE(world.outputs(0).gripper_closed);
  EXPECT_EQ(world.path(0).front(), (Point{-4.5, -4.5}));
  EXPECT_EQ(world.path(0).back(), (Point{4.5, 4.5}));
  EXPECT_EQ(world.count(0, "delivered"), 0) << "the drive that found it delivers nothing";
  world.run_for(400.0);
  EXPECT_GE(world.delivered(0), 5U);
  EXPECT_EQ(static_cast<std::uint32_t>(world.count(0, "delivered")), world.delivered(0));
  EXPECT_EQ(world.outputs(0).report.trips, static_cast<std::uint32_t>(world.count(0, "picked_up")));
}

TEST(Agent, ItsPathBecomesShorterAndNeverLeadsThroughWhatItCouldNotDrive) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    Config config = room();
    config.seed = seed;
    LineWorld world = world_of(config);
    world.add_robot({-4.0, -4.0}, 0.7);
    while (world.path(0).empty() && world.now_s() < 1200.0) world.step();
    const double found_m = length_m(world.path(0));
    world.run_for(600.0);
    EXPECT_LE(length_m(world.path(0)), found_m);
    EXPECT_LT(length_m(world.path(0)), 17.0) << "the straight line measures 12.7 m";
    const auto& path = world.path(0);
    for (std::size_t i = 1; i < path.size(); ++i) {
      EXPECT_GT((0.5 * (path[i] + path[i - 1])).norm(), 0.9) << "the box's middle";
    }
  }
}

bool cross_each_other(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto side = [](const Point& p, const Point& q, const Point& r) { return cross(q - p, r - p) > 0.0; };
  return side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
}

TEST(AgentProperty, NoPathThatItReportsEverLeadsThroughAWallSeenOrNot) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    pure::Random random{seed, 99};
    std::vector<test::Wall> walls;
    for (const double x : {-1.5, 1.0}) {  // at various angles to the straight line
      const Point middle{x, x + random.uniform(-1.0, 1.0)};
      const Point along = 1.8 * direction(0.785 + random.uniform(0.4, 2.7));
      walls.push_back({middle - along, middle + along});
    }
    Config config = room();
    config.seed = seed;
    LineWorld world{config};
    world.add_walls(test::rectangle({0, 0}, 12, 12));
    world.add_walls(walls);
    world.add_robot({-4.0, -4.0}, 0.7);
    for (int i = 0; i < 25000; ++i) {
      world.step();
      if (!world.outputs(0).report.path_changed) continue;
      const auto& path = world.path(0);
      for (std::size_t k = 1; k < path.size(); ++k) {
        for (const test::Wall& wall : walls) {
          ASSERT_FALSE(cross_each_other(path[k - 1], path[k], wall.a, wall.b)) << "at " << world.now_s();
        }
      }
    }
    EXPECT_GE(world.delivered(0), 3U);
  }
}

TEST(Agent, NothingToPickUpIsReportedAndDoesNotStopIt) {
  Config config = room();
  config.task.service_radius_m = 0.01;  // the world hands nothing over
  LineWorld world = world_of(config);
  world.add_robot({-4.0, -4.0}, 0.7);
  world.run_for(900.0);
  EXPECT_GE(world.count(0, "nothing_picked_up"), 2);
  EXPECT_EQ(world.outputs(0).report.trips, 0U);
}

}  // namespace
}  // namespace caravan::agent
