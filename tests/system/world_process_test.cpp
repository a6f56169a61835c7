// SPDX-License-Identifier: Apache-2.0
// The real world server; the test takes the place of its agents and its radio.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <thread>

#include "runtime/host/domain_lock.hpp"
#include "tests/system/support/bus_player.hpp"

namespace caravan::test {
namespace {

namespace msg = caravan_interfaces::msg;
using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Agents on one participant: answer every sensor frame with a command of the test's choice.
class PlayedFleet {
 public:
  using Choose = std::function<std::pair<double, double>(std::uint32_t robot)>;

  PlayedFleet(const runtime::BusConfig& bus, const std::vector<std::uint32_t>& robots, Choose choose)
      : choose_{std::move(choose)}, bus_{bus} {
    for (const std::uint32_t robot : robots) {
      commands_[robot] = bus_.writer<msg::RobotCommandPubSubType>(idl::kCommand, robot);
    }
    for (const std::uint32_t robot : robots) {
      bus_.reader<msg::SensorFramePubSubType>(
          idl::kSensors, robot,
          [this, robot](const msg::SensorFrame& frame, const auto&) { answer(robot, frame); });
    }
  }

 private:
  void answer(std::uint32_t robot, const msg::SensorFrame& frame) {
    const auto [left_mps, right_mps] = choose_(robot);
    msg::RobotCommand command;
    command.stamp(frame.stamp());
    command.session(frame.session());
    command.left_mps(left_mps);
    command.right_mps(right_mps);
    commands_.at(robot).write(command);
  }

  Choose choose_;
  std::map<std::uint32_t, runtime::Writer<msg::RobotCommandPubSubType>> commands_;
  runtime::Bus bus_;  // last, so that no callback outlives the rest
};

/// An agent that answers 100 ms late, about a hundred steps of a world at full speed, and only the newest
/// frame.
class SlowRobot {
 public:
  SlowRobot(const runtime::BusConfig& bus, std::uint32_t robot) : bus_{bus} {
    commands_ = bus_.writer<msg::RobotCommandPubSubType>(idl::kCommand, robot);
    bus_.reader<msg::SensorFramePubSubType>(idl::kSensors, robot,
                                            [this](const msg::SensorFrame& frame, const auto&) {
                                              const std::lock_guard lock{mutex_};
                                              newest_ = frame;
                                            });
    thread_ = std::jthread{[this](const std::stop_token& stop) {
      while (!stop.stop_requested()) answer_slowly();
    }};
  }

 private:
  void answer_slowly() {
    std::optional<msg::SensorFrame> frame;
    {
      const std::lock_guard lock{mutex_};
      frame = std::exchange(newest_, std::nullopt);
    }
    std::this_thread::sleep_for(100ms);
    if (!frame) return;
    msg::RobotCommand command;
    command.stamp(frame->stamp());
    command.session(frame->session());
    commands_.write(command);
  }

  std::mutex mutex_;
  std::optional<msg::SensorFrame> newest_;
  runtime::Writer<msg::RobotCommandPubSubType> commands_;
  runtime::Bus bus_;
  std::jthread thread_;  // last, so that it ends first
};

/// A radio on its own participant that delivers nothing.
class PlayedRadio {
 public:
  explicit PlayedRadio(runtime::BusConfig bus) : bus_{(bus.role = "radio_emulator", bus)} {
    steps_ = bus_.writer<msg::RadioStepPubSubType>(idl::kRadioStep);
    bus_.reader<msg::WorldTruthPubSubType>(idl::kTruth, 0, [this](const msg::WorldTruth& truth, const auto&) {
      msg::RadioStep step;
      step.stamp(truth.stamp());
      step.session(truth.session());
      steps_.write(step);
    });
  }

 private:
  runtime::Writer<msg::RadioStepPubSubType> steps_;
  runtime::Bus bus_;
};

class WorldProcess : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> world() const {
    return {"world_server", "--scenario", scenario("small.toml"), "--domain", std::to_string(lock_.domain())};
  }

  runtime::DomainLock lock_{std::nullopt};
  ScratchFolder folder_;
  Process world_{world(), folder_ / "world.log"};
  const runtime::BusConfig config_{.role = "test",
                                   .domain = lock_.domain(),
                                   .lease_s = 60.0};  // no process may be lost for lack of processor time
  PlayedRadio radio_{config_};
  Collector<msg::WorldStatusPubSubType> statuses_{config_, idl::kWorldStatus};
  Collector<msg::WorldTruthPubSubType> truths_{config_, idl::kTruth};
};

TEST_F(WorldProcess, ListsWhoIsMissingAtTheStart) {
  const PlayedFleet fleet{config_, {1, 3}, [](auto) { return std::pair{0.0, 0.0}; }};
  EXPECT_TRUE(statuses_.first([](const msg::WorldStatus& status) {
    return status.state() == msg::WorldStatus_Constants::WAITING &&
           status.missing() == std::vector<std::string>{"robot 2", "robot 4"};
  }));
}

TEST_F(WorldProcess, RefusesCommandsThatAreNotFiniteAndClampsThoseOverTheLimit) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const PlayedFleet fleet{
      config_, {1, 2, 3, 4}, [nan](std::uint32_t robot) {
        return robot == 1 ? std::pair{nan, 0.5} : robot == 2 ? std::pair{99.0, 99.0} : std::pair{0.0, 0.0};
      }};
  const auto status = statuses_.first([](const msg::WorldStatus& one) { return one.steps() > 60; });
  ASSERT_TRUE(status) << world_.output();
  EXPECT_GE(status->refused_commands(), 60U);
  EXPECT_GE(status->clamped_commands(), 60U);
  EXPECT_THAT(world_.output(), HasSubstr("command refused robot=1"));
  EXPECT_THAT(world_.output(), HasSubstr("command clamped robot=2"));
  const auto truth =
      truths_.first([](const msg::WorldTruth& one) { return idl::to_time(one.stamp()) == 32ms * 30; });
  const auto start =
      truths_.first([](const msg::WorldTruth& one) { return idl::to_time(one.stamp()) == 0ms; });
  ASSERT_TRUE(truth && start);
  const auto moved = [&](std::size_t i) {
    return std::hypot(truth->robots()[i].x_m() - start->robots()[i].x_m(),
                      truth->robots()[i].y_m() - start->robots()[i].y_m());
  };
  EXPECT_LT(moved(0), 1e-3);
  EXPECT_GT(moved(1), 0.2) << "clamped, not refused";
  EXPECT_LT(moved(1), 1.6 * 30 * 0.032);
}

TEST_F(WorldProcess, GoesOnWithoutARobotWhoseProcessIsGone) {
  const PlayedFleet fleet{config_, {1, 2, 3}, [](auto) { return std::pair{0.1, 0.1}; }};
  {
    const PlayedFleet fourth{config_, {4}, [](auto) { return std::pair{0.1, 0.1}; }};
    ASSERT_TRUE(truths_.first([](const msg::WorldTruth& one) { return one.members().size() == 4; }))
        << world_.output();
  }
  const auto without = truths_.first([](const msg::WorldTruth& one) { return one.members().size() == 3; });
  ASSERT_TRUE(without) << world_.output();
  EXPECT_THAT(without->members(), ElementsAre(1, 2, 3));
  EXPECT_TRUE(statuses_.first([&](const msg::WorldStatus& one) {
    return one.disturbed() && one.gone() == std::vector<std::string>{"robot 4"} &&
           idl::to_time(one.stamp()) > idl::to_time(without->stamp());
  })) << world_.output();
}

TEST_F(WorldProcess, TakesARobotBackThatIsTooSlowToAnswerAStepInTime) {
  const PlayedFleet fleet{config_, {1, 2, 3}, [](auto) { return std::pair{0.1, 0.1}; }};
  {
    const PlayedFleet fourth{config_, {4}, [](auto) { return std::pair{0.1, 0.1}; }};
    ASSERT_TRUE(statuses_.first([](const msg::WorldStatus& one) { return one.steps() > 0; }))
        << world_.output();
  }
  const auto is_whole = [](const msg::WorldStatus& one) { return one.disturbed() && one.members() == 4; };
  ASSERT_TRUE(statuses_.first([](const msg::WorldStatus& one) { return one.members() == 3; }))
      << world_.output();
  const SlowRobot slow{config_, 4};
  const auto back = statuses_.first(is_whole);
  ASSERT_TRUE(back) << world_.output();
  EXPECT_TRUE(statuses_.first([&](const msg::WorldStatus& one) {
    return is_whole(one) && one.steps() > back->steps() + 3;
  })) << "it is waited for, and the run goes on: "
      << world_.output();
}

TEST_F(WorldProcess, NamesARobotThatLivesButDoesNotAnswer) {
  const PlayedFleet fleet{config_, {1, 2, 3}, [](auto) { return std::pair{0.0, 0.0}; }};
  const Collector<msg::SensorFramePubSubType> sensors{config_, idl::kSensors, 4};
  runtime::Bus fourth{config_};
  auto commands = fourth.writer<msg::RobotCommandPubSubType>(idl::kCommand, 4);
  const auto first = sensors.first([](const msg::SensorFrame&) { return true; });
  ASSERT_TRUE(first);
  msg::RobotCommand command;
  command.stamp(first->stamp());
  command.session(first->session());
  commands.write(command);  // joins, then sends nothing more
  EXPECT_TRUE(statuses_.first([](const msg::WorldStatus& one) {
    return one.hung() == std::vector<std::string>{"robot 4"} && one.gone().empty();
  })) << world_.output();
  EXPECT_THAT(world_.output(), HasSubstr("robot 4"));
}

TEST_F(WorldProcess, NamesAnObserverThatLivesButHandlesNothingAndGoesOnWithoutIt) {
  runtime::BusConfig of_stuck = config_;
  of_stuck.role = "observer";
  runtime::Bus stuck{of_stuck};
  auto credits = stuck.writer<msg::RunCreditPubSubType>(idl::kRunCredit);
  msg::RunCredit credit;
  credit.observer("stuck");
  credits.write(credit);
  const PlayedFleet fleet{config_, {1, 2, 3, 4}, [](auto) { return std::pair{0.0, 0.0}; }};
  EXPECT_TRUE(world_.prints("observer stuck is alive but handles no more steps", kPatience))
      << world_.output();
  EXPECT_TRUE(world_.prints("observer stuck is no longer waited for", kPatience)) << world_.output();
  EXPECT_TRUE(statuses_.first([](const msg::WorldStatus& one) { return one.steps() > 300; }))
      << world_.output();
}

TEST_F(WorldProcess, StopsWithinASecondOnSigterm) {
  ASSERT_TRUE(statuses_.first([](const msg::WorldStatus&) { return true; }));
  world_.signal(SIGTERM);
  EXPECT_EQ(world_.wait(kPatience), 0) << world_.output();
}

}  // namespace
}  // namespace caravan::test
