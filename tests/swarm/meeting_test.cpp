// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <numbers>

#include "robot_agent/core/body.hpp"
#include "robot_agent/core/navigation/driver.hpp"
#include "tests/support/sonar_model.hpp"

namespace caravan::agent {
namespace {

using test::rectangle;
using test::Wall;

constexpr double kStep_s = 0.032;
constexpr double kRadioRange_m = 2.0;
constexpr double kReached_m = 0.5;
constexpr double kPi = std::numbers::pi;

/// A driver with limited acceleration, among others on an open floor.
struct Robot {
  Driver driver;
  Neighbours neighbours;
  Pose body;
  Twist twist;
  Point goal;
};

/// Robots that drive to their goals and report their positions to each other, without the rest of an agent.
class Floor {
 public:
  explicit Floor(std::uint64_t seed) : random_{seed} {}

  void add(const Point& at, double yaw_rad, const Point& goal) {
    robots_.push_back({Driver{DriverSettings{}}, Neighbours{{}, Time{0}}, {at, yaw_rad}, {}, goal});
  }
  void step() {
    const std::vector<Robot> before = robots_;
    for (std::size_t i = 0; i < robots_.size(); ++i) drive(i, before);
    now_ += std::chrono::milliseconds{32};
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        nearest_m_ = std::min(nearest_m_, distance_m(robots_[i].body, robots_[j].body, body_));
      }
    }
  }
  [[nodiscard]] bool has_reached(std::size_t i) const {
    return (robots_[i].body.p_WB - robots_[i].goal).norm() < kReached_m;
  }
  /// @return the time at which every robot has been at its goal; none: not within `seconds`
  [[nodiscard]] std::optional<double> all_reach_within(double seconds) {
    std::vector<bool> reached(robots_.size(), false);
    for (double passed = 0.0; passed < seconds; passed += kStep_s) {
      step();
      for (std::size_t i = 0; i < robots_.size(); ++i) reached[i] = reached[i] || has_reached(i);
      if (std::ranges::all_of(reached, [](bool there) { return there; })) return passed;
    }
    return std::nullopt;
  }
  [[nodiscard]] double nearest_m() const { return nearest_m_; }
  void send(std::size_t i, const Point& goal) { robots_[i].goal = goal; }
  [[nodiscard]] std::size_t size() const { return robots_.size(); }

 private:
  void drive(std::size_t i, const std::vector<Robot>& before) {
    Robot& robot = robots_[i];
    std::vector<Wall> walls;
    bool near = false;
    for (std::size_t j = 0; j < before.size(); ++j) {
      if (j == i) continue;
      const Pose& other = before[j].body;
      const Point centre = other.p_WB + (body_.ahead_m - 0.5 * body_.length_m) * direction(other.yaw_WB_rad);
      const auto sides = rectangle(centre, body_.length_m, body_.width_m, other.yaw_WB_rad);
      walls.insert(walls.end(), sides.begin(), sides.end());
      if ((other.p_WB - robot.body.p_WB).norm() <= kRadioRange_m) near = true;
    }
    Sensors sensors;
    sensors.p_WB = robot.body.p_WB;
    sensors.yaw_WB_rad = wrapped(robot.body.yaw_WB_rad);
    sensors.sonar_range_m = test::sonar_ranges_m(walls, sensors.p_WB, sensors.yaw_WB_rad);
    const Perception seen = perceive(now_, sensors, near, robot.neighbours.now(now_), {}, {}, body_);
    const Motion motion = robot.driver.drive_to(robot.goal, seen, random_);
    hear(i, before);
    move(robot, motion.wheels);
  }
  /// The WAITs that the others send now are received in the next step.
  void hear(std::size_t i, const std::vector<Robot>& before) {
    for (std::size_t j = 0; j < before.size(); ++j) {
      const Robot& other = before[j];
      if (j == i || (other.body.p_WB - robots_[i].body.p_WB).norm() > kRadioRange_m) continue;
      Sensors theirs;
      theirs.p_WB = other.body.p_WB;
      theirs.yaw_WB_rad = other.body.yaw_WB_rad;
      const Twist& moves = other.driver.twist();
      Wait wait;
      wait.from = RobotId{static_cast<std::uint16_t>(j + 1)};
      wait.whereabouts = whereabouts_of(theirs, moves.linear_mps, moves.angular_radps);
      robots_[i].neighbours.hear(wait, now_);
    }
  }
  void move(Robot& robot, const Wheels& wheels) const {
    const Twist wanted = twist_of(wheels, body_.track_m);
    Twist& now = robot.twist;
    now.linear_mps += std::clamp(wanted.linear_mps - now.linear_mps, -4.1 * kStep_s, 4.1 * kStep_s);
    now.angular_radps +=
        std::clamp(wanted.angular_radps - now.angular_radps, -20.0 * kStep_s, 20.0 * kStep_s);
    robot.body.yaw_WB_rad += kStep_s * now.angular_radps;
    robot.body.p_WB += kStep_s * now.linear_mps * direction(robot.body.yaw_WB_rad);
  }

  Body body_;
  pure::Random random_;
  std::vector<Robot> robots_;
  Time now_{0};
  double nearest_m_ = 1e9;
};

TEST(Meeting, TwoRobotsHeadOnPassWithoutContactAtAnyOffsetAndHeading) {
  for (const double offset_m : {-0.6, -0.4, -0.2, -0.05, 0.0, 0.1, 0.3, 0.5, 0.7}) {
    for (const double heading_rad : {-0.6, -0.2, 0.0, 0.3, 0.7}) {
      SCOPED_TRACE(testing::Message() << "offset " << offset_m << " heading " << heading_rad);
      Floor floor{1};
      floor.add({-3.0, 0.0}, heading_rad, {3.5, offset_m});
      floor.add({3.0, offset_m}, kPi + 0.5 * heading_rad, {-3.5, 0.0});
      const auto took_s = floor.all_reach_within(40.0);
      EXPECT_TRUE(took_s) << "they hold each other";
      EXPECT_GT(floor.nearest_m(), 0.0);
    }
  }
}

TEST(Meeting, ARobotPassesOneThatStandsInItsWay) {
  for (const double offset_m : {-0.3, -0.1, 0.0, 0.2}) {
    for (const double yaw_rad : {0.0, 0.8, 1.6, 3.1}) {
      SCOPED_TRACE(testing::Message() << "offset " << offset_m << " yaw " << yaw_rad);
      Floor floor{2};
      floor.add({-3.0, 0.0}, 0.0, {3.5, 0.0});
      floor.add({0.0, offset_m}, yaw_rad, {0.0, offset_m});
      EXPECT_TRUE(floor.all_reach_within(40.0));
      EXPECT_GT(floor.nearest_m(), 0.0);
    }
  }
}

TEST(Meeting, FourRobotsThatMeetAtOnePointAllCrossItWithoutContact) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    SCOPED_TRACE(seed);
    Floor floor{seed};
    for (int i = 0; i < 4; ++i) {
      const double yaw = 0.5 * kPi * i + 0.1 * static_cast<double>(seed);
      floor.add(-3.0 * direction(yaw), yaw, 3.5 * direction(yaw));
    }
    EXPECT_TRUE(floor.all_reach_within(60.0));
    EXPECT_GT(floor.nearest_m(), 0.0);
  }
}

TEST(Meeting, ACrowdThatDrivesToAndFroNeitherTouchesNorJams) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    pure::Random random{seed, 7};
    Floor floor{seed};
    for (int i = 0; i < 6; ++i) {
      const int row = i / 3;
      const Point at{i % 3 - 1.0, row - 0.5};
      floor.add(at, random.uniform(-kPi, kPi), at);
    }
    std::vector<int> reached(floor.size(), 0);
    for (double passed = 0.0; passed < 90.0; passed += kStep_s) {
      for (std::size_t i = 0; i < floor.size(); ++i) {
        if (!floor.has_reached(i)) continue;
        ++reached[i];
        floor.send(i, {random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)});
      }
      floor.step();
    }
    EXPECT_GT(floor.nearest_m(), 0.0);
    EXPECT_GE(*std::ranges::min_element(reached), 4);
  }
}

}  // namespace
}  // namespace caravan::agent
