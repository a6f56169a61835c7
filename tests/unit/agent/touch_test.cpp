// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/sensing/touch.hpp"

#include <gmock/gmock.h>

namespace caravan::agent {
namespace {

constexpr Time kStep = std::chrono::milliseconds{32};

/// Wheels that turn as the test says, whatever is commanded.
class Wheelwork {
 public:
  std::optional<Touch> run(int steps, const Wheels& told, const Wheels& turning) {
    std::optional<Touch> first;
    for (int i = 0; i < steps; ++i) {
      now_ += kStep;
      const double seconds = std::chrono::duration<double>(kStep).count();
      sensors_.left_wheel_rad += seconds * turning.left_mps / body_.wheel_radius_m;
      sensors_.right_wheel_rad += seconds * turning.right_mps / body_.wheel_radius_m;
      const auto touch = sensor_.update(now_, sensors_, told, body_);
      if (touch) ++touches_;
      if (touch && !first) first = touch;
    }
    return first;
  }
  [[nodiscard]] int touches() const { return touches_; }

 private:
  Body body_;
  TouchSensor sensor_{{}};
  Sensors sensors_;
  Time now_{0};
  int touches_ = 0;
};

TEST(TouchSensor, FeelsWhatStopsBothWheelsAheadOnceForEachTouch) {
  Wheelwork wheels;
  EXPECT_FALSE(wheels.run(20, {0.9, 0.9}, {0.9, 0.9}));
  const auto touch = wheels.run(20, {0.9, 0.9}, {0.0, 0.0});
  ASSERT_TRUE(touch);
  EXPECT_EQ(touch->at_B, (Point{0.2, 0.0}));
  EXPECT_EQ(touch->towards_B, (Point{1.0, 0.0}));
  EXPECT_EQ(wheels.touches(), 1);
}

// At a face met at more than 45 degrees, the wheel on the far side is slowed.
TEST(TouchSensor, DoesNotTakeTheWheelThatIsSlowedForTheSide) {
  for (const Wheels& turning : {Wheels{0.5, 0.9}, Wheels{0.9, 0.5}}) {
    Wheelwork wheels;
    EXPECT_FALSE(wheels.run(20, {0.9, 0.9}, {0.9, 0.9}));
    const auto touch = wheels.run(4, {0.9, 0.9}, turning);
    ASSERT_TRUE(touch);
    EXPECT_EQ(touch->at_B, (Point{0.2, 0.0}));
  }
}

TEST(TouchSensor, FeelsBehindWhileItBacksOff) {
  Wheelwork wheels;
  EXPECT_FALSE(wheels.run(20, {-0.3, -0.3}, {-0.3, -0.3}));
  const auto touch = wheels.run(4, {-0.3, -0.3}, {0.0, 0.0});
  ASSERT_TRUE(touch);
  EXPECT_NEAR(touch->at_B.x(), -0.285, 1e-9);
  EXPECT_EQ(touch->towards_B, (Point{-1.0, 0.0}));
}

TEST(TouchSensor, OfATurnOnTheSpotTheBaseTellsWhichCornerMeetsSomething) {
  struct Case {
    double turn, pushed;  // sign of the turn, left positive; sign of the motion of the base, forward positive
    double x, y;          // position of the corner in B
  };
  for (const Case& is : {Case{1, 1, -0.285, -0.1905}, Case{1, -1, 0.2, 0.1905}, Case{-1, 1, -0.285, 0.1905},
                         Case{-1, -1, 0.2, -0.1905}}) {
    SCOPED_TRACE(testing::Message() << is.turn << ' ' << is.pushed);
    Wheelwork wheels;
    const Wheels told{-0.4 * is.turn, 0.4 * is.turn};
    EXPECT_FALSE(wheels.run(20, told, told));
    const double slowed = 0.15 * is.turn;
    const auto touch = wheels.run(4, told, {-slowed + 0.1 * is.pushed, slowed + 0.1 * is.pushed});
    ASSERT_TRUE(touch);
    EXPECT_NEAR(touch->at_B.x(), is.x, 1e-9);
    EXPECT_NEAR(touch->at_B.y(), is.y, 1e-9);
    EXPECT_DOUBLE_EQ(touch->towards_B.y(), is.y > 0.0 ? 1.0 : -1.0);
  }
  Wheelwork wheels;
  EXPECT_FALSE(wheels.run(20, {-0.4, 0.4}, {-0.4, 0.4}));
  EXPECT_FALSE(wheels.run(20, {-0.4, 0.4}, {0.0, 0.0})) << "any corner";
}

TEST(TouchSensor, FeelsNothingInWheelsThatAreSlowToStartOrToldToBeSlower) {
  Wheelwork wheels;
  for (double speed = 0.0; speed < 0.9; speed += 0.01)
    EXPECT_FALSE(wheels.run(1, {0.9, 0.9}, {speed, speed}));
  EXPECT_FALSE(wheels.run(20, {0.9, 0.9}, {0.9, 0.9}));
  EXPECT_FALSE(wheels.run(1, {0.3, 0.3}, {0.7, 0.7}));
  EXPECT_FALSE(wheels.run(20, {0.3, 0.3}, {0.3, 0.3}));
  EXPECT_FALSE(wheels.run(20, {0.0, 0.0}, {0.0, 0.0}));
}

TEST(TouchSensor, FeelsNothingInWheelsThatAreHeldFromTheStart) {
  Wheelwork wheels;
  EXPECT_FALSE(wheels.run(60, {0.9, 0.9}, {0.0, 0.0})) << "the stuck monitor's";
}

TEST(TouchSensor, FeelsNothingInFramesThatAreRareAndLate) {
  TouchSensor sensor{{}};
  const Body body;
  Sensors sensors;
  Time now{0};
  for (int i = 0; i < 200; ++i) {
    const Time late{i % 3 == 0 ? 60'000'000 : 0};  // 10 frames a second, stamped at arrival, some late
    now = i * Time{100'000'000} + late;
    sensors.left_wheel_rad = sensors.right_wheel_rad = 0.06 * i / body.wheel_radius_m;
    EXPECT_FALSE(sensor.update(now, sensors, {0.6, 0.6}, body));
  }
}

TEST(TouchSensor, FeelsNothingInWheelsWhoseAnglesAreNotKnown) {
  TouchSensor sensor{{}};
  Sensors sensors;
  sensors.left_wheel_rad = sensors.right_wheel_rad = std::numeric_limits<double>::quiet_NaN();
  for (int i = 1; i < 40; ++i) EXPECT_FALSE(sensor.update(i * kStep, sensors, {0.9, 0.9}, Body{}));
}

}  // namespace
}  // namespace caravan::agent
