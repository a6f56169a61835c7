// SPDX-License-Identifier: Apache-2.0
// The emulated Pioneer, with the test in the place of its host: any program that drives a real one can drive
// it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "hardware_bridge/core/arcos/command.hpp"
#include "hardware_bridge/core/arcos/odometry.hpp"
#include "hardware_bridge/core/arcos/sip.hpp"
#include "hardware_bridge/core/nmea/sentence.hpp"
#include "hardware_bridge/core/pose/arena_projection.hpp"
#include "tests/system/bridge/support/field.hpp"
#include "tests/system/bridge/support/socket.hpp"

namespace caravan::test {
namespace {

using bridge::arcos::Bytes;
using bridge::arcos::encode;
using bridge::arcos::Order;
using bridge::arcos::Sip;
using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::SizeIs;

/// A host on TCP: says what it is told, collects what comes.
class Host {
 public:
  explicit Host(std::uint16_t port) : socket_{Socket::to(port)} {}
  [[nodiscard]] bool is_connected() const { return socket_.has_value(); }
  void say(const Bytes& packet) {
    if (socket_ && !socket_->write(packet)) socket_.reset();
  }
  void listen(std::chrono::milliseconds patience) {
    if (!socket_) return;
    const auto bytes = socket_->read(patience);
    if (!bytes) return socket_.reset();
    for (Bytes& data : packets_.feed(*bytes)) heard_.push_back(std::move(data));
  }
  /// The next packet within the tests' patience.
  [[nodiscard]] std::optional<Bytes> next() {
    (void)eventually(
        [&] {
          if (heard_.empty()) listen(50ms);
          return !heard_.empty() || !socket_;
        },
        kPatience);
    if (heard_.empty()) return std::nullopt;
    Bytes first = std::move(heard_.front());
    heard_.erase(heard_.begin());
    return first;
  }
  /// The next SIP for which `wanted(sip)` holds, saying `meanwhile` all the time.
  template <typename Wanted>
  [[nodiscard]] std::optional<Sip> sip(Wanted wanted, const Bytes& meanwhile = encode(Order::kPulse)) {
    std::optional<Sip> found;
    (void)eventually(
        [&] {
          const auto data = next();
          const auto sip = data ? bridge::arcos::decode_sip(*data) : std::nullopt;
          if (sip && wanted(*sip)) found = sip;
          say(meanwhile);
          return found || !socket_;
        },
        kPatience);
    return found;
  }
  void open() {
    for (const Order order : {Order::kPulse, Order::kOpen, Order::kClose}) {
      say(encode(order));
      (void)next();
    }
    say(encode(Order::kOpen));
    say(encode(Order::kEnable, 1));
    say(encode(Order::kSonar, 1));
    say(encode(Order::kSetAcceleration, 2000));
    say(encode(Order::kSetAcceleration, -2000));
  }
  void hang_up() { socket_.reset(); }

 private:
  std::optional<Socket> socket_;
  bridge::arcos::PacketFinder packets_;
  std::vector<Bytes> heard_;
};

class ArcosRobot : public Field {
 protected:
  void SetUp() override {
    world_ = start_world(room(1, 0), "1");
    robot_ = start_robot(1);
    ASSERT_TRUE(world_->prints("started robots=1", kPatience))
        << world_->output() << robot_.process->output();
    ASSERT_TRUE(truth_.is_there());
  }
  static Bytes wheels(double left_mps, double right_mps) {
    return encode(Order::kWheelSpeeds, bridge::arcos::wheel_speeds_argument(left_mps, right_mps));
  }

  std::unique_ptr<Process> world_;
  Robot robot_;
  Truth truth_{bus()};
};

TEST_F(ArcosRobot, ShakesHandsAsAPioneerDoes) {
  Host host{robot_.port};
  ASSERT_TRUE(host.is_connected());
  host.say(encode(Order::kPulse));
  EXPECT_EQ(host.next(), Bytes{0});
  host.say(encode(Order::kOpen));
  EXPECT_EQ(host.next(), Bytes{1});
  host.say(encode(Order::kClose));
  const auto names = bridge::arcos::decode_names(host.next().value_or(Bytes{}));
  ASSERT_TRUE(names);
  EXPECT_EQ(names->type, "Pioneer");
  EXPECT_EQ(names->subtype, "p3dx");
  host.say(encode(Order::kOpen));
  EXPECT_TRUE(host.sip([](const Sip&) { return true; })) << robot_.process->output();
}

TEST_F(ArcosRobot, DrivesThroughTheWorldAndReckonsAsItDoes) {
  Host host{robot_.port};
  host.open();
  const auto begin = truth_.of(1);
  ASSERT_TRUE(begin);
  bridge::arcos::Odometry odometry{*bridge::arcos::factors_of("p3dx")};
  double turned = 0.0;
  const auto moved = host.sip(
      [&](const Sip& sip) {
        turned += odometry.follow(sip).turned_rad;
        return turned > 1.5;
      },
      wheels(-0.1, 0.1));
  ASSERT_TRUE(moved) << robot_.process->output();
  EXPECT_TRUE(moved->moving);
  EXPECT_TRUE(host.sip([](const Sip& sip) { return !sip.moving; }, encode(Order::kStop)));
  const auto end = truth_.of(1);
  EXPECT_NEAR(bridge::wrapped(end->yaw_rad() - begin->yaw_rad()), turned, 0.25);
}

TEST_F(ArcosRobot, SonarsComeInTurnAndSeeTheWorld) {
  Host host{robot_.port};
  host.open();
  std::map<int, int> seen;
  const auto all = host.sip([&](const Sip& sip) {
    for (const Sip::Sonar& sonar : sip.sonars) seen[sonar.index] = sonar.range_mm;
    return seen.size() == bridge::kSonarCount;
  });
  ASSERT_TRUE(all) << seen.size();
  EXPECT_LT(all->sonars.size(), bridge::kSonarCount) << "one of each array at a time";
  EXPECT_TRUE(std::any_of(seen.begin(), seen.end(), [](const auto& one) { return one.second < 5000; }))
      << "some wall of the room";
}

TEST_F(ArcosRobot, AHostThatHangsUpStopsTheWheels) {
  Host host{robot_.port};
  host.open();
  ASSERT_TRUE(host.sip([](const Sip& sip) { return sip.left_mmps < -50; }, wheels(-0.1, 0.1)));
  host.hang_up();
  EXPECT_TRUE(robot_.process->prints("the host has gone", kPatience));
  EXPECT_TRUE(truth_.rests(1));
  Host second{robot_.port};
  second.open();
  EXPECT_TRUE(second.sip([](const Sip&) { return true; })) << "the next one is welcome";
}

TEST_F(ArcosRobot, TheWatchdogStopsARobotWhoseHostSaysNothing) {
  Host host{robot_.port};
  host.open();
  ASSERT_TRUE(host.sip([](const Sip& sip) { return sip.left_mmps < -50; }, wheels(-0.1, 0.1)));
  EXPECT_TRUE(eventually(
      [&] {
        const auto data = host.next();
        const auto sip = data ? bridge::arcos::decode_sip(*data) : std::nullopt;
        return sip && !sip->moving;
      },
      kPatience));
}

TEST_F(ArcosRobot, TakesOneHostAtATime) {
  Host first{robot_.port};
  first.open();
  ASSERT_TRUE(first.sip([](const Sip&) { return true; }));
  Host second{robot_.port};
  second.say(encode(Order::kPulse));
  EXPECT_EQ(second.next(), std::nullopt);
  EXPECT_TRUE(first.sip([](const Sip&) { return true; }));
}

TEST_F(ArcosRobot, ItsGpsSaysWhereItIsOnEarth) {
  const auto receiver = Socket::to(robot_.gps_port);
  ASSERT_TRUE(receiver);
  const bridge::ArenaProjection projection{{48.137, 11.575, 0.3}};
  bridge::nmea::SentenceFinder sentences;
  std::optional<bridge::Point> told;
  (void)eventually(
      [&] {
        const auto bytes = receiver->read(50ms).value_or(Bytes{});
        for (const std::string& sentence : sentences.feed(bytes)) {
          const auto parsed = bridge::nmea::parse(sentence);
          const auto* gga = parsed ? std::get_if<bridge::nmea::Gga>(&*parsed) : nullptr;
          if (gga != nullptr) told = projection.to_arena(gga->latitude_deg, gga->longitude_deg);
        }
        return told.has_value();
      },
      kPatience);
  ASSERT_TRUE(told);
  EXPECT_NEAR(told->x_m, truth_.of(1)->x_m(), 0.01);
  EXPECT_NEAR(told->y_m, truth_.of(1)->y_m(), 0.01);
}

TEST_F(ArcosRobot, AnotherSessionOfTheWorldIsARobotSwitchedOffAndOn) {
  Host host{robot_.port};
  host.open();
  ASSERT_TRUE(host.sip([](const Sip&) { return true; }));
  kill_at_once(*world_);
  world_ = start_world(room(1, 0), "1");
  EXPECT_TRUE(eventually(
      [&] {
        host.listen(50ms);
        host.say(encode(Order::kPulse));
        return !host.is_connected();
      },
      kPatience))
      << "the connection ends";
  EXPECT_TRUE(eventually(
      [&] {
        Host again{robot_.port};
        again.say(encode(Order::kPulse));
        return again.next() == Bytes{0};
      },
      kPatience));
}

TEST_F(Field, BodiesNeedFreePacing) {
  auto world = start_world(replaced(room(1, 0), "\"free\"", "\"fast\""), "1");
  EXPECT_EQ(world->wait(kPatience), 2);
  EXPECT_THAT(world->output(), HasSubstr("--bodies: experiment.pacing must be \"free\""));
  auto other = start_world(room(1, 0), "2");
  EXPECT_EQ(other->wait(kPatience), 2);
  EXPECT_THAT(other->output(), HasSubstr("--bodies"));
}

}  // namespace
}  // namespace caravan::test
