// SPDX-License-Identifier: Apache-2.0
// Paced runs: lockstep in real time (realtime), and without ever waiting (free).
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "runtime/host/domain_lock.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr auto kRunPatience = 40s;

/// Processor time of all processes that have ended and been waited for, including their children.
double ended_cpu_s() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

class Pacing : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> run(const std::string& name,
                                             std::vector<std::string> options) const {
    std::vector<std::string> line{"caravan",      "run",      scenario("small.toml"),        "--out",
                                  folder_ / name, "--domain", std::to_string(lock_.domain())};
    line.insert(line.end(), options.begin(), options.end());
    return line;
  }
  [[nodiscard]] nlohmann::json metrics(const std::string& name) const {
    return nlohmann::json::parse(read_file(folder_ / (name + "/metrics.json")));
  }
  [[nodiscard]] pid_t pid_of_agent(const std::string& robot) const {
    for (const pid_t pid : processes_in(lock_.domain())) {
      std::string line = read_file("/proc/" + std::to_string(pid) + "/cmdline");
      std::replace(line.begin(), line.end(), '\0', ' ');
      if (line.find("--robot " + robot) != std::string::npos) return pid;
    }
    return -1;
  }
  void expect_nothing_left() const {
    EXPECT_THAT(processes_in(lock_.domain()), IsEmpty());
    EXPECT_THAT(left_in_shared_memory(lock_.domain()), IsEmpty());
  }

  runtime::DomainLock lock_{std::nullopt};
  ScratchFolder folder_;
};

TEST_F(Pacing, RealtimeGivesTheSameRunAsFastAndNoFasterThanTheClock) {
  const std::vector<std::string> what{"--items", "0", "--max-time", "4", "--pacing"};
  auto with = [&](const std::string& pacing) {
    std::vector<std::string> options = what;
    options.push_back(pacing);
    return options;
  };
  Process fast{run("fast", with("fast")), folder_ / "fast.log"};
  ASSERT_EQ(fast.wait(kRunPatience), 0) << fast.output();
  Process realtime{run("realtime", with("realtime")), folder_ / "realtime.log"};
  ASSERT_EQ(realtime.wait(kRunPatience), 0) << realtime.output();

  EXPECT_EQ(metrics("realtime").at("digest"), metrics("fast").at("digest"));
  EXPECT_LE(metrics("realtime").at("real_time_factor"), 1.02);
  expect_nothing_left();
}

TEST_F(Pacing, WaitingForTheClockCostsNoProcessorTime) {
  constexpr double kSimulated_s = 6.0;
  const auto cpu_s = [&](const std::string& pacing) {
    const double before_s = ended_cpu_s();
    Process caravan{
        run(pacing, {"--items", "0", "--max-time", std::to_string(kSimulated_s), "--pacing", pacing}),
        folder_ / (pacing + ".log")};
    EXPECT_EQ(caravan.wait(kRunPatience), 0) << caravan.output();
    return ended_cpu_s() - before_s;
  };
  const double fast_s = cpu_s("fast");
  // The steps are the same. A process that polled the clock would use as much processor time as the run
  // lasts.
  EXPECT_LT(cpu_s("realtime"), fast_s + 0.5 * kSimulated_s);
}

TEST_F(Pacing, FreeEndsAtItsTimeAndSaysWhenThatWasTooShort) {
  Process caravan{run("out", {"--pacing", "free", "--max-time", "4"}), folder_ / "caravan.log"};
  EXPECT_EQ(caravan.wait(kRunPatience), 1) << caravan.output();
  EXPECT_FALSE(metrics("out").at("completed"));
  EXPECT_NEAR(metrics("out").at("sim_time_s"), 4.0, 0.032);
  EXPECT_LE(metrics("out").at("real_time_factor"), 1.02);
  expect_nothing_left();
}

TEST_F(Pacing, FreeWaitsForNobodyAndARobotThatFallsSilentStops) {
  Process caravan{run("out", {"--pacing", "free", "--items", "0", "--max-time", "8"}),
                  folder_ / "caravan.log"};
  ASSERT_TRUE(eventually([&] { return pid_of_agent("2") > 0; }, kRunPatience));
  const auto tracks = [&] { return read_file(folder_ / "out/tracks.csv"); };
  ASSERT_TRUE(eventually([&] { return tracks().find("\n2.") != std::string::npos; }, kRunPatience))
      << caravan.output();
  const pid_t silent = pid_of_agent("2");
  ASSERT_EQ(kill(silent, SIGSTOP), 0);
  const bool went_on = eventually([&] { return tracks().find("\n6.") != std::string::npos; }, kRunPatience);
  kill(silent, SIGCONT);
  ASSERT_TRUE(went_on) << caravan.output();
  ASSERT_EQ(caravan.wait(kRunPatience), 0) << caravan.output();

  const auto place = [&, rows = tracks()](const std::string& second, const std::string& robot) {
    const std::size_t at_second = rows.find("\n" + second + ".");
    const std::size_t row = rows.find("," + robot + ",", at_second);
    return rows.substr(row, rows.find(',', rows.find(',', row + 3) + 1) - row);
  };
  EXPECT_EQ(place("5", "2"), place("6", "2")) << "the deadman has stopped its wheels";
  EXPECT_NE(place("5", "1"), place("6", "1")) << "the others drive on";
  EXPECT_THAT(read_file(folder_ / "out/events.csv"), HasSubstr(",2,left"));
  EXPECT_TRUE(metrics("out").at("disturbed"));
}

}  // namespace
}  // namespace caravan::test
