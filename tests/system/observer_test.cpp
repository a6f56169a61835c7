// SPDX-License-Identifier: Apache-2.0
// The observer of the launcher. The test takes the place of the world and of an agent whose telemetry is
// late.
#include "deploy/observer/observer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/host/domain_lock.hpp"
#include "tests/system/support/bus_player.hpp"

namespace caravan::test {
namespace {

namespace msg = caravan_interfaces::msg;
using namespace std::chrono_literals;
using experiment::Time;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// The observer of one robot, and the truths of ten steps. The second and the fifth of them say that robot 1
/// reported in the step before.
class ObserverOfOne : public ::testing::Test {
 protected:
  ObserverOfOne() {
    for (int step = 0; step < 10; ++step) {
      msg::WorldTruth truth;
      truth.stamp(idl::to_wire(step * 32ms));
      truth.session(7);
      truth.members({1});
      if (step == 1 || step == 4) truth.reported({1});
      truths_.write(truth);
    }
  }

  void report(Time stamp, std::uint8_t activity) {
    msg::Telemetry report;
    report.stamp(idl::to_wire(stamp));
    report.session(7);
    report.activity(activity);
    telemetry_.write(report);
  }

  [[nodiscard]] bool gives_out(std::size_t steps) {
    return eventually(
        [&] {
          for (experiment::Observation& one : observer_.look().observations) seen_.push_back(std::move(one));
          return seen_.size() == steps;
        },
        kPatience);
  }

  /// The robots whose reports belong to the step.
  [[nodiscard]] std::vector<std::uint32_t> reports_of(std::size_t step) const {
    std::vector<std::uint32_t> robots;
    for (const experiment::AgentReport& one : seen_[step].agent_reports) robots.push_back(one.robot);
    return robots;
  }

  const runtime::DomainLock lock_{std::nullopt};
  runtime::Loop loop_;
  deploy::Observer observer_{{.role = "observer", .domain = lock_.domain()}, "observer", 1, loop_};
  runtime::Bus world_{{.role = "world_server", .domain = lock_.domain()}};
  runtime::Bus agent_{{.role = "robot_agent 1", .domain = lock_.domain()}};
  runtime::Writer<msg::WorldTruthPubSubType> truths_ = world_.writer<msg::WorldTruthPubSubType>(idl::kTruth);
  runtime::Writer<msg::TelemetryPubSubType> telemetry_ =
      agent_.writer<msg::TelemetryPubSubType>(idl::kTelemetry, 1);
  std::vector<experiment::Observation> seen_;
};

TEST_F(ObserverOfOne, PutsAReportThatComesLateToTheStepThatItBelongsTo) {
  report(0ms, msg::Telemetry_Constants::ACTIVITY_DRIVING);
  EXPECT_TRUE(gives_out(3)) << "the fourth step waits for its report, the later ones behind it";
  report(96ms, msg::Telemetry_Constants::ACTIVITY_AVOIDING);
  ASSERT_TRUE(gives_out(9));
  EXPECT_THAT(reports_of(0), ElementsAre(1));
  EXPECT_THAT(reports_of(3), ElementsAre(1));
  EXPECT_EQ(seen_[3].agent_reports[0].activity, experiment::Activity::kAvoiding);
}

TEST_F(ObserverOfOne, LeavesOutReportsBeyondTheLimits) {
  msg::Telemetry far;
  far.stamp(idl::to_wire(0ms));
  far.session(7);
  far.path_changed(true);
  far.path().resize(2);
  far.path()[1].x_m(std::numeric_limits<double>::infinity());
  telemetry_.write(far);
  report(96ms, 99);
  ASSERT_TRUE(gives_out(9));
  EXPECT_THAT(reports_of(0), IsEmpty());
  EXPECT_THAT(reports_of(3), IsEmpty());
}

TEST_F(ObserverOfOne, WaitsForNoReportOfALostRobot) {
  report(0ms, msg::Telemetry_Constants::ACTIVITY_DRIVING);
  ASSERT_TRUE(gives_out(3));
  msg::WorldTruth alone;
  alone.stamp(idl::to_wire(9 * 32ms));
  alone.session(7);
  truths_.write(alone);
  ASSERT_TRUE(gives_out(9));
  EXPECT_THAT(reports_of(3), IsEmpty());
}

}  // namespace
}  // namespace caravan::test
