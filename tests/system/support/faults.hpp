// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "tests/system/support/patient_deployment.hpp"
#include "tests/system/support/process.hpp"

/// Code shared by the tests of faults. docs/faults.md lists them and the defects that they detect.
namespace caravan::test {

using namespace std::chrono_literals;

/// The small room with the destination in sight of the start: soon every robot has a path and exchanges it
/// repeatedly.
inline constexpr const char* kBusy = R"(
robots.destination_m = [-1.0, -4.5]
algorithm.sharing_starts_s = 2.0
algorithm.recontact_after_s = 2.0
experiment.items = 100000
experiment.max_time_s = 100000.0
)";

class Faults : public PatientDeployment {
 protected:
  void start_busy(const std::string& more = "", double lease_s = short_lease_s(), bool hold_start = false) {
    deploy({.scenario = scenario("small.toml"),
            .changes = kBusy + more,
            .lease_s = lease_s,
            .hold_start = hold_start});
  }
  void start_all_busy(const std::string& more = "", double lease_s = short_lease_s()) {
    start_busy(more, lease_s);
    ASSERT_TRUE(does("start all"));
    ASSERT_TRUE(happens("everybody comes", "step > 20 and members is 4"));
  }
  [[nodiscard]] ::testing::AssertionResult goes_on() {
    const std::string later = "step > " + std::to_string(seen().step + 200);
    return happens("the run goes on", later);
  }
  /// Suspends a process while it waits. A process that is stopped in the middle of a send or a receive may
  /// hold a lock in shared memory that all others need: a limit of DDS, not the subject of these tests.
  void suspend_at_rest(const std::string& who) {
    suspended_at_ = std::chrono::steady_clock::now();
    ASSERT_TRUE(does("pause"));
    ASSERT_TRUE(happens("it is paused", "state is paused"));
    ASSERT_TRUE(does("suspend " + who));
    if (who == "world") return;
    ASSERT_TRUE(does("resume"));
  }
  /// Waits until the process suspended last has been suspended for this long, in wall time like its lease.
  [[nodiscard]] ::testing::AssertionResult stays_suspended_for(double time_s) {
    const std::chrono::duration<double> time{time_s};
    return happens(
        std::to_string(time_s) + " s are over",
        [&](const deploy::Seen&) { return std::chrono::steady_clock::now() - suspended_at_ > time; },
        std::chrono::duration_cast<std::chrono::milliseconds>(2.0 * time));
  }
  void expect_back_and_working(std::uint32_t robot) {
    const std::string name = "robot " + std::to_string(robot);
    const std::string number = std::to_string(robot);
    EXPECT_TRUE(happens(name + " is back", "gone lacks \"" + name + "\" and member " + number + " is yes"));
    EXPECT_TRUE(happens(name + " has a path again", "mode " + number + " is transport", 90s));
  }

 private:
  std::chrono::steady_clock::time_point suspended_at_;
};

}  // namespace caravan::test
