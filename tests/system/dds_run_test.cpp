// SPDX-License-Identifier: Apache-2.0
// Whole runs of the command over DDS: their records, and the faults that they survive.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "build_paths.hpp"
#include "runtime/host/domain_lock.hpp"
#include "runtime/pure/random.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::chrono::milliseconds kRunPatience{100'000};

struct EventRow {
  double time_s = 0.0;
  int robot = 0;
  std::string name;
};

std::vector<EventRow> read_events(const std::filesystem::path& file) {
  std::vector<EventRow> rows;
  std::istringstream lines{read_file(file)};
  std::string line;
  std::getline(lines, line);  // the header
  while (std::getline(lines, line)) {
    std::istringstream cells{line};
    EventRow row;
    char comma = 0;
    cells >> row.time_s >> comma >> row.robot >> comma;
    std::getline(cells, row.name, ',');
    rows.push_back(row);
  }
  return rows;
}

class DdsRun : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> run(std::vector<std::string> options = {}) const {
    std::vector<std::string> line{"caravan",       "run",      scenario("small.toml"),        "--out",
                                  folder_ / "out", "--domain", std::to_string(lock_.domain())};
    line.insert(line.end(), options.begin(), options.end());
    return line;
  }
  [[nodiscard]] nlohmann::json metrics() const {
    return nlohmann::json::parse(read_file(folder_ / "out/metrics.json"));
  }
  [[nodiscard]] std::vector<EventRow> events() const { return read_events(folder_ / "out/events.csv"); }
  [[nodiscard]] pid_t pid_of(const std::string& program, const std::string& more = "") const {
    return pid_in(lock_.domain(), program, more);
  }
  void expect_nothing_left() const {
    EXPECT_THAT(processes_in(lock_.domain()), IsEmpty());
    EXPECT_THAT(left_in_shared_memory(lock_.domain()), IsEmpty());
  }
  [[nodiscard]] bool seen(const std::string& event) const {
    return eventually(
        [&] {
          const auto rows = events();
          return std::any_of(rows.begin(), rows.end(),
                             [&](const EventRow& row) { return row.name == event; });
        },
        kRunPatience);
  }

  // The test holds the lock; the run is given its domain.
  runtime::DomainLock lock_{std::nullopt};
  ScratchFolder folder_;
};

TEST_F(DdsRun, NeedsNoNetwork) {
  const std::vector<std::string> no_network{"/usr/bin/unshare", "--map-root-user", "--net"};
  std::vector<std::string> probe = no_network;
  probe.emplace_back("true");
  if (PatientProcess allowed{probe, folder_ / "probe.log"}; allowed.wait(kRunPatience) != 0) {
    GTEST_SKIP() << "no network namespaces here: " << allowed.output();
  }
  std::vector<std::string> line = no_network;
  for (const std::string& word : run({"--items", "1"})) line.push_back(word);
  line[no_network.size()] = std::string{CARAVAN_BIN_DIR} + "/caravan";
  PatientProcess launcher{line, folder_ / "launcher.log"};
  EXPECT_EQ(launcher.wait(kRunPatience), 0) << "not even the loopback is up: " << launcher.output();
  EXPECT_EQ(metrics()["items_delivered"], 1);
}

TEST_F(DdsRun, DeliversTheItemsAndLeavesNothingBehind) {
  Process caravan{run(), folder_ / "caravan.log"};
  ASSERT_EQ(caravan.wait(kRunPatience), 0) << caravan.output();
  EXPECT_EQ(metrics().at("items_delivered"), 4);
  EXPECT_EQ(metrics().at("engine"), "dds");
  EXPECT_FALSE(metrics().at("disturbed"));
  expect_nothing_left();
}

TEST_F(DdsRun, EndsWithOneWhenTheTimeRunsOut) {
  Process caravan{run({"--max-time", "5"}), folder_ / "caravan.log"};
  EXPECT_EQ(caravan.wait(kRunPatience), 1) << caravan.output();
  EXPECT_FALSE(metrics().at("completed"));
  expect_nothing_left();
}

TEST_F(DdsRun, AnInterruptAtAnyMomentStopsEverybody) {
  const std::uint64_t seed = 20;
  SCOPED_TRACE(seed);
  pure::Random random{seed};
  for (int attempt = 0; attempt < 6; ++attempt) {
    const auto moment = std::chrono::milliseconds{static_cast<int>(random.uniform(10.0, 1500.0))};
    SCOPED_TRACE(moment.count());
    const std::string out = folder_ / ("out" + std::to_string(attempt));
    Process caravan{{"caravan", "run", scenario("small.toml"), "--out", out, "--items", "1000", "--domain",
                     std::to_string(lock_.domain())},
                    folder_ / "caravan.log"};
    ASSERT_TRUE(caravan.runs_on_for(moment)) << caravan.output();
    caravan.signal(SIGINT);
    EXPECT_EQ(caravan.wait(10s), 130) << caravan.output();
    expect_nothing_left();
  }
}

/// The launcher does not wait for the last status of a radio that has ended.
TEST_F(DdsRun, ThatLostItsRadioEndsAsSoonAsItsWorldHasFinished) {
  Process caravan{run({"--items", "1000", "--max-time", "300"}), folder_ / "caravan.log"};
  const auto has = [this](const char* file, const std::string& text) {
    return eventually([&] { return read_file(folder_ / "out" / file).find(text) != std::string::npos; },
                      kRunPatience);
  };
  ASSERT_TRUE(has("tracks.csv", "\n10.")) << caravan.output();
  ASSERT_EQ(kill(pid_of("radio_emulator"), SIGKILL), 0);
  ASSERT_TRUE(has("logs/world_server.log", "finished sim_s=300")) << caravan.output();
  EXPECT_EQ(caravan.wait(5s), 1) << "half of what it would be waited for";
  EXPECT_THAT(caravan.output(), HasSubstr("radio_emulator (pid "));
  expect_nothing_left();
}

TEST_F(DdsRun, WithoutItsRadioTheSwarmStopsExchangingAndNothingElse) {
  Process caravan{run({"--items", "1000", "--max-time", "1500"}), folder_ / "caravan.log"};
  ASSERT_TRUE(seen("exchange")) << caravan.output();
  const std::size_t before = events().size();
  ASSERT_EQ(kill(pid_of("radio_emulator"), SIGTERM), 0);
  EXPECT_EQ(caravan.wait(kRunPatience), 1) << caravan.output();
  const std::vector<EventRow> rows = events();
  // Exchanges under way when the radio was lost may still end: a session ends by its own timer.
  const double lost_s = rows[before - 1].time_s + 30.0;
  std::set<int> delivering;
  for (const EventRow& row : rows) {
    if (row.time_s < lost_s) continue;
    EXPECT_NE(row.name, "exchange") << "at " << row.time_s << " s, radio lost by " << lost_s << " s";
    if (row.name == "delivery") delivering.insert(row.robot);
  }
  EXPECT_EQ(delivering.size(), 4U) << "every robot goes on carrying";
  EXPECT_TRUE(metrics().at("disturbed"));
  expect_nothing_left();
}

TEST_F(DdsRun, TheSwarmGoesOnWithoutARobotThatWasKilled) {
  Process caravan{run({"--items", "1000", "--max-time", "900"}), folder_ / "caravan.log"};
  ASSERT_TRUE(seen("delivery")) << caravan.output();
  ASSERT_EQ(kill(pid_of("robot_agent", "--robot 2"), SIGKILL), 0);
  EXPECT_EQ(caravan.wait(kRunPatience), 1) << caravan.output();
  double left_s = 0.0;
  std::set<int> delivering;
  for (const EventRow& row : events()) {
    if (row.name == "left" && row.robot == 2) left_s = row.time_s;
    if (left_s > 0.0 && row.name == "delivery") delivering.insert(row.robot);
  }
  EXPECT_GT(left_s, 0.0) << "its loss is recorded";
  EXPECT_THAT(delivering, ::testing::UnorderedElementsAre(1, 3, 4));
  expect_nothing_left();
}

TEST_F(DdsRun, ARobotThatWasKilledAndStartedAgainRejoins) {
  Process caravan{run({"--items", "1000", "--max-time", "3000"}), folder_ / "caravan.log"};
  ASSERT_TRUE(seen("delivery")) << caravan.output();
  ASSERT_EQ(kill(pid_of("robot_agent", "--robot 2"), SIGKILL), 0);
  const Process again{{"robot_agent", "--scenario", folder_ / "out/scenario.toml", "--domain",
                       std::to_string(lock_.domain()), "--robot", "2"},
                      folder_ / "again.log"};
  EXPECT_TRUE(seen("left")) << caravan.output();
  EXPECT_TRUE(seen("joined")) << again.output();
  caravan.signal(SIGINT);
  EXPECT_EQ(caravan.wait(10s), 130);
}

}  // namespace
}  // namespace caravan::test
