// SPDX-License-Identifier: Apache-2.0
#include "world_server/physics/physics_error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <thread>

#include "runtime/config/start_error.hpp"
#include "tests/unit/world/worlds.hpp"
#include "world_server/physics/dynamics.hpp"
#include "world_server/world.hpp"

namespace caravan::world {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Bodies that no scenario may have, to provoke errors of ODE.
WorldConfig with_wheels_of(double radius_m) {
  WorldConfig config = empty_world(20.0, 1);
  config.robots.wheel_radius_m = radius_m;
  return config;
}

/// The error that ends a minute of driving such robots, or the first complaint; empty if there is neither.
std::string end_of(const WorldConfig& config, std::span<const Pose> starts) {
  try {
    Dynamics dynamics{config, starts};
    for (std::uint64_t step = 0; step < steps_in(60.0); ++step) {
      for (std::size_t robot = 0; robot < starts.size(); ++robot)
        dynamics.drive(robot, 0.8, step % 100 < 50 ? 0.8 : 0.4);
      dynamics.advance();
      if (!dynamics.complaint().empty()) return dynamics.complaint();
    }
    return "";
  } catch (const PhysicsError& error) {
    return error.what();
  }
}

TEST(PhysicsError, NamesTheRobotAndWhatOdeSaysWhereItWouldEndTheProcess) {
  const std::array starts{Pose{0.0, 0.0, 0.0}, Pose{5.0, 0.0, 0.0}};
  EXPECT_THAT(end_of(with_wheels_of(1e-9), starts),
              AllOf(StartsWith("robot 1: ODE: "), HasSubstr("assertion")));
}

TEST(PhysicsComplaint, NamesTheRobotsForWhichTheSolverGivesUpAndTheWorldGoesOn) {
  std::string complaint;
  for (const double aside : {0.0, 0.1, 0.2, 0.3, 0.36, 0.38}) {
    for (const double skew : {-0.3, -0.05, 0.0, 0.02, 0.2}) {
      const std::array starts{Pose{-3.0, 0.0, 0.0}, Pose{3.0, aside, std::numbers::pi + skew}};
      Dynamics dynamics{empty_world(30.0, 2), starts};
      for (const std::size_t robot : {0, 1}) dynamics.drive(robot, 1.6, 1.6);
      for (std::uint64_t step = 0; step < steps_in(8.0); ++step) {
        dynamics.advance();
        if (complaint.empty()) complaint = dynamics.complaint();
      }
    }
  }
  EXPECT_THAT(complaint, StartsWith("robot 1 and robot 2: ODE: LCP"));
}

TEST(PhysicsError, OfAWorldThatIsJustMadeSaysThatItsBodyIsRefused) {
  WorldConfig config = empty_world(20.0, 1);
  config.robots.mass_kg = 0.0;
  try {
    const World world{config};
    ADD_FAILURE() << "made";
  } catch (const runtime::StartError& error) {
    EXPECT_THAT(error.what(), AllOf(StartsWith("robots: the physics refuses this body"), HasSubstr("ODE")));
  }
}

TEST(PhysicsError, LeavesOtherWorldsOfTheProcessAndTheThreadAsTheyAre) {
  const std::array starts{Pose{0.0, 0.0, 0.3}};
  const auto last_place = [&] {
    Dynamics dynamics{empty_world(20.0, 1), starts};
    for (int step = 0; step < 100; ++step) {
      dynamics.drive(0, 0.7, 0.5);
      dynamics.advance();
    }
    return dynamics.poses()[0].x_m;
  };
  const double before = last_place();
  EXPECT_NE(end_of(with_wheels_of(1e-9), starts), "");
  EXPECT_EQ(last_place(), before);
}

}  // namespace
}  // namespace caravan::world
