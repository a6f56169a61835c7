// SPDX-License-Identifier: Apache-2.0
// The launcher's observer, with the test in the place of the world and of an agent whose telemetry is late.
#include "deploy/launcher/observer.hpp"

#include <gtest/gtest.h>

#include "deploy/launcher/domain_lock.hpp"
#include "tests/system/support/bus_player.hpp"

namespace caravan::test {
namespace {

namespace msg = caravan_interfaces::msg;
using namespace std::chrono_literals;

TEST(Observer, PutsAFirstReportThatComesLateToTheStepThatItBelongsTo) {
  const deploy::DomainLock lock{std::nullopt};
  runtime::Loop loop;
  deploy::Observer observer{{.role = "observer", .domain = lock.domain()}, "observer", 1, loop};
  runtime::Bus bus{{.role = "test", .domain = lock.domain()}};
  auto truths = bus.writer<msg::WorldTruthPubSubType>(idl::kTruth);
  for (int step = 0; step < 10; ++step) {
    msg::WorldTruth truth;
    truth.stamp(idl::to_wire(step * 32ms));
    truth.session(7);
    truth.members({1});
    truths.write(truth);
  }
  const Collector<msg::RunCreditPubSubType> credits{{.role = "test", .domain = lock.domain()},
                                                    idl::kRunCredit};
  ASSERT_TRUE(credits.first([](const msg::RunCredit&) { return true; }));
  EXPECT_TRUE(observer.look().observations.empty()) << "robot 1 has not been heard yet";

  auto telemetry = bus.writer<msg::TelemetryPubSubType>(idl::kTelemetry, 1);
  msg::Telemetry report;
  report.session(7);
  report.activity(msg::Telemetry_Constants::ACTIVITY_DRIVING);
  telemetry.write(report);
  std::vector<deploy::Observation> seen;
  ASSERT_TRUE(eventually(
      [&] {
        for (deploy::Observation& one : observer.look().observations) seen.push_back(std::move(one));
        return seen.size() == 9;
      },
      kPatience));
  ASSERT_EQ(seen[0].agent_reports.size(), 1U);
  EXPECT_EQ(seen[0].stamp, 0ms);
  EXPECT_EQ(seen[0].agent_reports[0].activity, deploy::Activity::kDriving);
}

}  // namespace
}  // namespace caravan::test
