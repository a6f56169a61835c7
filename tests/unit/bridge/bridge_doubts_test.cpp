// SPDX-License-Identifier: Apache-2.0
// The checks of a bridge on positions, on its robot and on its lines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "hardware_bridge/core/host/notice_limit.hpp"
#include "tests/unit/bridge/bridge_loop.hpp"

namespace caravan::bridge {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// Replaces `from` in a sentence and corrects its checksum.
std::string with(const std::string& line, const std::string& from, const std::string& to) {
  const std::size_t place = line.find(from);
  if (place == std::string::npos) return line;
  std::string sentence = line.substr(1, line.find('*') - 1);
  sentence.replace(place - 1, from.size(), to);
  unsigned sum = 0;
  for (const char c : sentence) sum ^= static_cast<unsigned char>(c);
  std::array<char, 8> end{};
  std::snprintf(end.data(), end.size(), "*%02X\r\n", sum);
  return "$" + sentence + end.data();
}

/// Applies `change` to each line.
std::function<std::string(std::string)> each(const std::function<std::string(std::string)>& change) {
  return [change](const std::string& lines) {
    std::string changed;
    for (std::size_t at = 0; at < lines.size();) {
      const std::size_t end = lines.find('\n', at) + 1;
      changed += change(lines.substr(at, end - at));
      at = end;
    }
    return changed;
  };
}

TEST_F(DrivingLoop, AFixFarFromTheOthersIsRefusedAndStopsTheRobotUntilSeveralAgree) {
  const std::size_t before = frames_.size();
  gps_error_ = {93.0, 0.0};
  run(110ms);  // one fix
  gps_error_ = {};
  EXPECT_LE(rest_after(5s), 200ms);
  EXPECT_THAT(told_, HasSubstr("GPS: fix 93 m from the expected place refused until 5 in a row agree"));
  run(2s);
  EXPECT_TRUE(moves_) << "the next ones agree";
  for (std::size_t i = before; i < frames_.size(); ++i) {
    EXPECT_FALSE(std::abs(frames_[i].x_m) >= 20.0) << "NaN or near";
  }
}

TEST_F(DrivingLoop, AnotherPlaceIsTakenOnceSeveralFixesAgreeOnIt) {
  wish_ = {};
  run(1s);
  place_ = {20.0, 10.0};  // somebody has moved the robot
  run(300ms);
  EXPECT_TRUE(std::isnan(frames_.back().x_m));
  run(700ms);
  EXPECT_NEAR(frames_.back().x_m, 20.0, 0.5);
  EXPECT_NEAR(frames_.back().y_m, 10.0, 0.5);
}

TEST_F(DrivingLoop, OneFixInTenThatIsFarOffMovesNothingAndIsNotToldEachTime) {
  NoticeLimit limit;
  std::size_t told = 0;
  for (int i = 0; i < 600; ++i) {
    gps_error_ = i % 10 == 0 ? Point{0.0, 100.0} : Point{};
    told_.clear();
    run(100ms);
    EXPECT_FALSE(std::abs(frames_.back().x_m - place_.x_m) >= 2.0) << i << ": NaN or near";
    if (told_.find("refused") == std::string::npos) continue;
    told += limit.pass({Notice::Weight::kWarning, "GPS: fix 100 m off"}, now_) ? 1 : 0;
    told += limit.take_due(now_).size();
  }
  EXPECT_GE(told, 3U);
  EXPECT_LE(told, 6U) << "in a minute";
}

TEST_F(DrivingLoop, FixesThatCannotBeTrueAreRefusedByTheirReasonAndStopTheRobot) {
  const struct {
    const char* from;
    const char* to;
    const char* told;
  } cases[] = {
      {",N,", ",S,", "from the arena's origin refused"},
      {",1,10,0.9,", ",6,10,0.9,", "estimated position (quality 6)"},
      {",1,10,0.9,", ",7,10,0.9,", "quality 7"},
      {",1,10,0.9,", ",8,10,0.9,", "quality 8"},
      {",1,10,0.9,", ",1,03,99.9,", "fix too poor: 3 satellites, HDOP 99.9"},
      {",480", ",010", "from the arena's origin refused"},
      {",480", ",486", "out of its range"},
  };
  for (const auto& one : cases) {
    SCOPED_TRACE(std::string{one.from} + " becomes " + one.to);
    told_.clear();
    change_gps_ = each([&](const std::string& line) { return with(line, one.from, one.to); });
    EXPECT_LE(rest_after(5s), 600ms);
    EXPECT_THAT(told_, HasSubstr(one.told));
    EXPECT_THAT(told_, HasSubstr("position lost"));
    change_gps_ = each([](const std::string& line) { return line; });
    run(2s);
    EXPECT_TRUE(moves_);
  }
}

TEST_F(DrivingLoop, PositionZeroIsNotInTheArena) {
  change_gps_ = each([&](const std::string& line) {
    return with(line, line.substr(line.find(",48"), line.find("E,") - line.find(",48")),
                ",0000.0000000,N,00000.0000000,");
  });
  EXPECT_LE(rest_after(5s), 600ms);
  EXPECT_THAT(told_, HasSubstr("km from the arena's origin refused"));
}

TEST_F(DrivingLoop, AFixThatIsRepeatedIsNoNewOne) {
  std::string first;
  change_gps_ = [&](const std::string& lines) {
    if (lines.empty()) return lines;
    if (first.empty()) first = lines;
    return first;
  };
  EXPECT_LE(rest_after(5s), 600ms);
  EXPECT_THAT(told_, HasSubstr("GPS: the receiver repeats one fix"));
}

TEST_F(Loop, AReceiverThatHasNoFixFromTheStartIsCalledSoOnce) {
  gps_works_ = false;
  connect();
  run(30s);
  const std::size_t told = told_.find("the receiver has no fix in the first 10.0 s");
  ASSERT_NE(told, std::string::npos) << told_;
  EXPECT_EQ(told_.find("has no fix", told + 20), std::string::npos) << told_;
}

TEST_F(Loop, AReceiverWithoutGgaIsCalledSo) {
  change_gps_ =
      each([](const std::string& line) { return line.find("GGA") == std::string::npos ? line : ""; });
  connect();
  EXPECT_THAT(told_, HasSubstr("GPS: the receiver sends RMC but no GGA"));
}

TEST_F(DrivingLoop, AReceiverSlowerThanTheLimitIsToldWithBothNumbers) {
  int fixes = 0;
  change_gps_ = [&](const std::string& lines) { return !lines.empty() && fixes++ % 10 == 0 ? lines : ""; };
  run(15s);
  EXPECT_THAT(told_, HasSubstr("fix every 1.0 s, limit 0.4 s: raise bridge.gps_timeout_s"));
}

TEST_F(DrivingLoop, FixesThatArriveLateAreToldAndStopTheRobot) {
  // A line that carries 70 % of the data that the receiver sends.
  std::string waiting;
  double room = 0.0;
  change_gps_ = [&](const std::string& lines) {
    waiting += lines;
    room += 0.01 * 0.7 * 1400.0;
    const std::string out = waiting.substr(0, static_cast<std::size_t>(room));
    waiting.erase(0, out.size());
    room -= static_cast<double>(out.size());
    return out;
  };
  run(20s);
  EXPECT_THAT(told_, HasSubstr("GPS: fixes arrive more than 1 s late"));
  EXPECT_FALSE(moves_);
}

TEST_F(Loop, SomethingElseOnTheGpsLineIsCalledSo) {
  change_gps_ = [](const std::string& lines) { return std::string(lines.size(), '\x7a'); };
  connect();
  run(2s);
  EXPECT_THAT(told_, HasSubstr("no NMEA sentence in 1000 bytes"));
}

TEST_F(DrivingLoop, ALineThatIsCutFromHostToRobotAloneIsTold) {
  robot_hears_ = false;
  run(4s);
  EXPECT_THAT(told_, HasSubstr("does not receive ours (cut from host to robot?): wheels told to stop"));
  EXPECT_FALSE(moves_);
  EXPECT_FALSE(bridge_.may_move(now_));
  robot_hears_ = true;
  run(2s);
  EXPECT_TRUE(moves_);
  EXPECT_THAT(told_, HasSubstr("the robot's line works again"));
}

class LoopWithAnotherKind : public Loop {
 protected:
  explicit LoopWithAnotherKind(const BridgeConfig& config = bridge_config())
      : Loop{config, [] {
               RobotConfig robot = robot_config();
               robot.subtype = "p3at";
               return robot;
             }()} {}
};

TEST_F(LoopWithAnotherKind, ARobotOfUnknownScaleIsRefused) {
  connect();
  EXPECT_THAT(
      unfit_,
      HasSubstr("robot subtype p3at: the scale of its odometry is not known; set bridge.position_count_m"));
  EXPECT_THAT(frames_, IsEmpty());
}

class LoopWithAGivenScale : public LoopWithAnotherKind {
 protected:
  LoopWithAGivenScale()
      : LoopWithAnotherKind{[] {
          BridgeConfig config = bridge_config();
          config.position_count_m = 0.001;
          return config;
        }()} {}
};

TEST_F(LoopWithAGivenScale, IsTakenWithTheScenariosScale) {
  connect();
  EXPECT_THAT(unfit_, IsEmpty());
  EXPECT_THAT(frames_, Not(IsEmpty()));
}

TEST_F(DrivingLoop, AJumpOfTheOdometryIsNoWay) {
  arcos::Sip sip;
  sip.flags = arcos::kMotorsOn;
  sip.x = 5000;
  gps_speaks_ = false;
  const Frame before = frames_.back();
  bridge_.robot_says(arcos::to_packet(encode(sip)), now_);
  step();
  EXPECT_THAT(told_, HasSubstr("odometry jumped by"));
  EXPECT_LT(std::hypot(frames_.back().x_m - before.x_m, frames_.back().y_m - before.y_m), 0.2);
}

}  // namespace
}  // namespace caravan::bridge
