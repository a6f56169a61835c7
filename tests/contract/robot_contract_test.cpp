// SPDX-License-Identifier: Apache-2.0
// What an agent requires of the provider of its robot. Times are taken from the stamps of the frames, so
// these tests do not depend on the speed of the machine.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "tests/contract/providers.hpp"
#include "tests/system/bridge/support/played_agent.hpp"

namespace caravan::test {
namespace {

using namespace std::chrono_literals;
using Frame = PlayedAgent::Frame;
using Command = PlayedAgent::Command;

constexpr double kWheelRadius_m = 0.0975;
constexpr double kWheelLimit_mps = 1.6;

double seconds(const builtin_interfaces::msg::Time& stamp) {
  return std::chrono::duration<double>(idl::to_time(stamp)).count();
}
bool is_placed(const Frame& frame) {
  return std::isfinite(frame.gps_x_m()) && std::isfinite(frame.gps_y_m()) &&
         std::isfinite(frame.compass_yaw_rad());
}

class RobotContract : public ContractField {
 protected:
  /// Starts an agent and waits until its robot knows its position.
  void play(PlayedAgent::Choose choose) {
    agent_.emplace(bus(), 1, std::move(choose));
    ASSERT_TRUE(eventually([&] { return !agent_->frames().empty() && is_placed(agent_->frames().back()); },
                           kPatience));
  }
  /// The frames with a known position from now on, until their stamps span `span_s`.
  [[nodiscard]] std::vector<Frame> watch(double span_s) {
    const std::size_t first = agent_->frames().size();
    std::vector<Frame> frames;
    (void)eventually(
        [&] {
          const auto all = agent_->frames();
          frames.clear();
          std::copy_if(all.begin() + static_cast<std::ptrdiff_t>(first), all.end(),
                       std::back_inserter(frames), is_placed);
          return frames.size() > 1 &&
                 seconds(frames.back().stamp()) - seconds(frames.front().stamp()) >= span_s;
        },
        kPatience);
    return frames;
  }

  std::optional<PlayedAgent> agent_;
};

TEST_P(RobotContract, StampsGrowWithinOneSession) {
  play(drives(0.0, 0.0));
  const auto frames = watch(3.0);
  ASSERT_GT(frames.size(), 3U);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    EXPECT_LT(seconds(frames[i - 1].stamp()), seconds(frames[i].stamp()));
    EXPECT_EQ(frames[i].session(), frames[0].session());
    EXPECT_FALSE(frames[i].radio_due()) << "nobody waits on hardware";
  }
}

TEST_P(RobotContract, PlaceAndHeadingAreThoseOfTheArena) {
  play(drives(0.0, 0.0));
  const auto frames = watch(3.0);
  ASSERT_FALSE(frames.empty());
  const auto truth = truth_.of(1);
  ASSERT_TRUE(truth);
  EXPECT_NEAR(frames.back().gps_x_m(), truth->x_m(), 0.2);
  EXPECT_NEAR(frames.back().gps_y_m(), truth->y_m(), 0.2);
  EXPECT_NEAR(std::remainder(frames.back().compass_yaw_rad() - truth->yaw_rad(), 2.0 * std::numbers::pi), 0.0,
              0.1);
  for (const Frame& frame : frames) EXPECT_LE(std::abs(frame.compass_yaw_rad()), std::numbers::pi + 1e-12);
}

TEST_P(RobotContract, SonarsAreDistancesNoEchoOrNotKnown) {
  play(drives(0.0, 0.0));
  const auto frames = watch(2.0);
  ASSERT_FALSE(frames.empty());
  int echoes = 0;
  for (std::size_t i = 0; i < 16; ++i) {
    const double range = frames.back().sonar_range_m()[i];
    EXPECT_TRUE(range >= 0.0) << "sonar " << i << ": +inf without echo, and known by now";
    EXPECT_GE(frames.back().sonar_age_s()[i], 0.0);
    EXPECT_LE(frames.back().sonar_age_s()[i], 1.0) << "older ones are of no use to an agent that drives";
    echoes += range < 5.0 ? 1 : 0;
  }
  EXPECT_GT(echoes, 0) << "there are walls";
}

TEST_P(RobotContract, DrivingAheadMovesItAlongItsHeading) {
  play(drives(0.2, 0.2));
  (void)watch(1.5);
  const auto frames = watch(2.0);
  ASSERT_GT(frames.size(), 2U);
  const Frame& first = frames.front();
  const Frame& last = frames.back();
  const double span = seconds(last.stamp()) - seconds(first.stamp());
  const double way = std::hypot(last.gps_x_m() - first.gps_x_m(), last.gps_y_m() - first.gps_y_m());
  const double along = (last.gps_x_m() - first.gps_x_m()) * std::cos(last.compass_yaw_rad()) +
                       (last.gps_y_m() - first.gps_y_m()) * std::sin(last.compass_yaw_rad());
  EXPECT_GT(along, 0.9 * way) << "forward is where the heading points";
  EXPECT_LE(way / span, 0.26);
  EXPECT_GE(way / span, 0.05) << "a busy machine may have made it stop on the way";
  EXPECT_NEAR((last.left_wheel_rad() - first.left_wheel_rad()) * kWheelRadius_m, way, 0.2 * way + 0.02);
  EXPECT_NEAR((last.right_wheel_rad() - first.right_wheel_rad()) * kWheelRadius_m, way, 0.2 * way + 0.02);
}

TEST_P(RobotContract, AFasterRightWheelTurnsItCounterClockwise) {
  play(drives(-0.1, 0.1));
  (void)watch(1.5);
  const auto frames = watch(1.5);
  ASSERT_GT(frames.size(), 2U);
  const Frame& first = frames.front();
  const Frame& last = frames.back();
  const double span = seconds(last.stamp()) - seconds(first.stamp());
  const double turned =
      std::remainder(last.compass_yaw_rad() - first.compass_yaw_rad(), 2.0 * std::numbers::pi);
  EXPECT_LE(turned / span, 0.2 / 0.33 + 0.2);
  EXPECT_GE(turned / span, 0.1);
  EXPECT_LT(last.left_wheel_rad(), first.left_wheel_rad());
  EXPECT_GT(last.right_wheel_rad(), first.right_wheel_rad());
}

TEST_P(RobotContract, NoCommandTurnsAWheelFasterThanTheLimit) {
  play(drives(-99.0, 99.0));
  (void)watch(1.5);
  const auto frames = watch(2.0);
  ASSERT_GT(frames.size(), 2U);
  const double span = seconds(frames.back().stamp()) - seconds(frames.front().stamp());
  const double rate = (frames.back().right_wheel_rad() - frames.front().right_wheel_rad()) / span;
  EXPECT_LE(rate * kWheelRadius_m, 1.15 * kWheelLimit_mps);
  EXPECT_GE(rate * kWheelRadius_m, 0.2) << "clamped, not refused";
}

TEST_P(RobotContract, WithoutCommandsItStopsAndFramesGoOn) {
  play(drives(0.15, 0.35));
  ASSERT_TRUE(truth_.drives(1));
  agent_->choose([](const Frame&, Command&) { return false; });
  EXPECT_TRUE(truth_.rests(1));
  EXPECT_GT(watch(1.0).size(), 1U);
  agent_->choose(drives(0.15, 0.35));
  EXPECT_TRUE(truth_.drives(1)) << "and it goes on with the next command";
}

TEST_P(RobotContract, NonsenseMovesNothing) {
  play(drives(0.15, 0.35));
  ASSERT_TRUE(truth_.drives(1));
  agent_->choose([](const Frame&, Command& command) {
    command.left_mps(std::numeric_limits<double>::quiet_NaN());
    command.right_mps(std::numeric_limits<double>::infinity());
    return true;
  });
  EXPECT_TRUE(truth_.rests(1)) << "not finite";
  agent_->choose([](const Frame& frame, Command& command) {
    command.session(frame.session() - 1);
    command.left_mps(0.15);
    command.right_mps(0.35);
    return true;
  });
  EXPECT_TRUE(truth_.rests(1)) << "of another session";
  agent_->choose([](const Frame& frame, Command& command) {
    command.stamp(idl::to_wire(std::max(0ns, idl::to_time(frame.stamp()) - 2s)));
    command.left_mps(0.15);
    command.right_mps(0.35);
    return true;
  });
  EXPECT_TRUE(truth_.rests(1)) << "two seconds old";
  agent_->choose(drives(0.15, 0.35));
  EXPECT_TRUE(truth_.drives(1)) << "and none of it does harm for ever";
}

TEST_P(RobotContract, TheGripperTakesAnItemAtTheSourceAndLetsItGo) {
  play([](const Frame&, Command& command) {
    command.gripper_closed(true);
    return true;
  });
  EXPECT_TRUE(eventually([&] { return agent_->frames().back().holding(); }, kPatience));
  agent_->choose(drives(0.0, 0.0));
  EXPECT_TRUE(eventually([&] { return !agent_->frames().back().holding(); }, kPatience));
}

std::string name_of(const ::testing::TestParamInfo<Provider>& provider) { return provider.param.name; }

INSTANTIATE_TEST_SUITE_P(Contract, RobotContract, ::testing::ValuesIn(providers()), name_of);

}  // namespace
}  // namespace caravan::test
