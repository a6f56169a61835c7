// SPDX-License-Identifier: Apache-2.0
// The deployment test kit itself: its actions are repeatable, and its failures are reported.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "deploy/kit/tally.hpp"
#include "runtime/bus/reach.hpp"
#include "runtime/bus/shared_memory_port.hpp"
#include "tests/system/support/patient_deployment.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

class DeploymentKit : public PatientDeployment {
 protected:
  /// Runs the small scenario for 40 simulated seconds, with or without faults.
  std::string digest_of_a_run(bool with_faults) {
    deploy({.scenario = scenario("small.toml"),
            .changes = "experiment.items = 1000\nexperiment.max_time_s = 40.0",
            .lease_s = short_lease_s(),
            .hold_start = true});
    EXPECT_TRUE(does("start all"));
    if (with_faults) {
      EXPECT_TRUE(does("radio cut 1 2 at 150"));
      EXPECT_TRUE(does("teleport 1 5 0 1.5 at 200"));
      EXPECT_TRUE(does("remove 2 at 250"));
      EXPECT_TRUE(does("hold 4 at 300"));
      EXPECT_TRUE(does("spawn 2 5 -5 1.5 at 400"));
    }
    EXPECT_TRUE(does("go"));
    if (with_faults) {
      EXPECT_TRUE(does("hold_at 600"));
      EXPECT_TRUE(does("kill robot 3"));
      EXPECT_TRUE(does("resume"));
    }
    EXPECT_TRUE(happens("the time runs out", "state is finished"));
    EXPECT_EQ(seen().disturbed, with_faults);
    return seen().digest;
  }
};

TEST_F(DeploymentKit, FaultsAtAStepGiveTheSameRunEveryTime) {
  const std::string first = digest_of_a_run(true);
  EXPECT_EQ(first.size(), 16U);
  EXPECT_EQ(digest_of_a_run(true), first);
  EXPECT_NE(digest_of_a_run(false), first);
}

/// The records of the same run by `caravan run` with the embedded engine.
class RecordOfARun {
 public:
  RecordOfARun(const std::filesystem::path& scenario, const ScratchFolder& folder) {
    Process run{{"caravan", "run", scenario, "--engine", "embedded", "--quiet", "--out", folder / "out"},
                folder / "log"};
    EXPECT_EQ(run.wait(60s), 1) << "the time runs out: " << run.output();
    metrics_ = nlohmann::json::parse(read_file(folder / "out/metrics.json"));
    std::istringstream rows{read_file(folder / "out/events.csv")};
    std::string row;
    std::getline(rows, row);  // the header
    while (std::getline(rows, row)) {
      const std::size_t robot = row.find(',') + 1;
      const std::size_t event = row.find(',', robot) + 1;
      ++events_[{row.substr(event, row.find(',', event) - event),
                 static_cast<std::uint32_t>(std::stoul(row.substr(robot)))}];
    }
  }
  /// As text, so that numbers, words and unknown values compare alike.
  [[nodiscard]] std::string metric(std::string key, std::uint32_t robot) const {
    std::replace(key.begin(), key.end(), '.', '/');
    const nlohmann::json& found = (robot == 0 ? metrics_ : metrics_.at("per_robot").at(robot - 1))
                                      .at(nlohmann::json::json_pointer("/" + key));
    if (found.is_boolean()) return found.get<bool>() ? "yes" : "no";
    if (found.is_number()) return std::to_string(found.get<double>());
    return found.is_string() ? found.get<std::string>() : "unknown";
  }
  [[nodiscard]] const std::map<std::pair<std::string, std::uint32_t>, std::uint32_t>& events() const {
    return events_;
  }

 private:
  nlohmann::json metrics_;
  std::map<std::pair<std::string, std::uint32_t>, std::uint32_t> events_;
};

std::string to_text(const std::optional<deploy::Tally::Number>& metric) {
  if (!metric) return "unknown";
  const double* number = std::get_if<double>(&*metric);
  return number != nullptr ? std::to_string(*number) : std::get<std::string>(*metric);
}

TEST_F(DeploymentKit, SeesTheMetricsAndEventsThatTheRecordOfTheSameRunHas) {
  // The destination is in sight of the start, so that much happens within 25 simulated seconds.
  deploy({.scenario = scenario("small.toml"),
          .changes = "robots.destination_m = [-1.0, -4.5]\nalgorithm.sharing_starts_s = 2.0\n"
                     "algorithm.recontact_after_s = 2.0\nexperiment.items = 1000\n"
                     "experiment.max_time_s = 25.0",
          .lease_s = 60.0});
  ASSERT_TRUE(does("start all"));
  ASSERT_TRUE(happens("the run ends", "state is finished and metric sim_time_s >= 25", 100s));
  ASSERT_TRUE(happens("its digest is known", "metric digest is not \"\""));
  const ScratchFolder record_folder;
  const RecordOfARun record{deployment().folder() / "scenario.toml", record_folder};
  const auto tally = seen().tally;
  for (const std::string& key : deploy::metric_keys().of_run) {
    if (key.find("wall") != std::string::npos || key == "real_time_factor" || key.starts_with("time_split"))
      continue;
    EXPECT_EQ(to_text(tally->metric(key, 0)), record.metric(key, 0)) << key;
  }
  for (std::uint32_t robot = 1; robot <= 4; ++robot) {
    for (const std::string& key : deploy::metric_keys().of_robot)
      EXPECT_EQ(to_text(tally->metric(key, robot)), record.metric(key, robot)) << key << " " << robot;
  }
  EXPECT_GE(record.events().size(), 6U);
  for (const auto& [what, count] : record.events())
    EXPECT_EQ(tally->events(what.first, what.second), count) << what.first << " of robot " << what.second;
  EXPECT_TRUE(happens("in words", "events exchange > 0 and event exchange 1 has partner=", 0s));
}

TEST_F(DeploymentKit, TellsWhatItWaitedForAndWhatItSaw) {
  deploy({.scenario = scenario("small.toml")});
  ASSERT_TRUE(does("start world"));
  ASSERT_TRUE(happens("the world is up", "state is waiting"));
  const deploy::ActionResult result =
      deployment().expect("a robot comes", deploy::Condition{"missing lacks \"robot 3\""}, 300ms);
  EXPECT_FALSE(result.good);
  EXPECT_THAT(result.text, HasSubstr("a robot comes: not within 0.3"));
  EXPECT_THAT(result.text, HasSubstr("expected: missing lacks \"robot 3\""));
  EXPECT_THAT(result.text, HasSubstr("robot 1, robot 2, robot 3, robot 4]\n"));
  EXPECT_THAT(result.text, HasSubstr("world running;"));
  EXPECT_THAT(result.text, HasSubstr("logs: "));
}

TEST_F(DeploymentKit, RobotsThatShareAProcessDieAndComeBackTogether) {
  deploy({.scenario = scenario("small.toml"),
          .changes = "robots.count = 3\nexperiment.items = 1000",
          .lease_s = short_lease_s(),
          .agents_per_process = 2});
  ASSERT_TRUE(does("start all"));
  ASSERT_TRUE(happens("it runs", "members is 3 and step > 50"));
  const auto processes = seen().processes;
  EXPECT_EQ(processes.at("robot 1").pid, processes.at("robot 2").pid);
  EXPECT_NE(processes.at("robot 1").pid, processes.at("robot 3").pid) << "the last group is smaller";
  ASSERT_TRUE(does("kill robot 2"));
  EXPECT_TRUE(
      happens("both are gone",
              "gone has \"robot 1\" and gone has \"robot 2\" and members is 1 and exit robot 1 is 137"));
  ASSERT_TRUE(does("start robot 1-2"));
  EXPECT_TRUE(happens("both are back", "gone is none and members is 3 and process robot 2 is running"));
  EXPECT_TRUE(std::filesystem::exists(deployment().folder() / "robots_1-2.2.log"));
  EXPECT_EQ(seen().processes.at("robot 3").pid, processes.at("robot 3").pid);
}

TEST_F(DeploymentKit, GoesByTheTransportThatItIsTold) {
  deploy({.scenario = scenario("small.toml"), .transport = "udp", .lease_s = 60.0});
  ASSERT_TRUE(does("start all"));
  ASSERT_TRUE(happens("it runs", "members is 4 and step > 50"));
  for (const auto& [name, process] : seen().processes) {
    const std::string maps = read_file("/proc/" + std::to_string(process.pid) + "/maps");
    EXPECT_THAT(maps, HasSubstr(runtime::dds_library())) << name;
    EXPECT_THAT(maps, ::testing::Not(HasSubstr("/dev/shm/" + runtime::shared_memory_mark())))
        << name << " shares memory";
  }
}

TEST_F(DeploymentKit, LeavesNothingBehind) {
  std::uint32_t domain = 0;
  {
    const deploy::Deployment& made = deploy({.scenario = scenario("small.toml"), .lease_s = short_lease_s()});
    domain = made.domain();
    ASSERT_TRUE(does("start all"));
    ASSERT_TRUE(happens("it runs", "step > 50"));
    ASSERT_TRUE(does("kill robot 2,3"));
    ASSERT_TRUE(does("suspend robot 4"));
  }
  end_deployment();
  EXPECT_THAT(processes_in(domain), ::testing::IsEmpty());
  EXPECT_THAT(left_in_shared_memory(domain), ::testing::IsEmpty());
}

class DeployCommand : public ::testing::Test {
 protected:
  int run(const std::string& steps, const std::vector<std::string>& options = {}) {
    write_file(folder_ / "script.toml", "scenario = \"" + scenario("small.toml").string() + "\"\n" + steps);
    std::vector<std::string> line{"caravan", "deploy", folder_ / "script.toml", "--out", folder_ / "out"};
    line.insert(line.end(), options.begin(), options.end());
    Process process{line, folder_ / "log"};
    const auto code = process.wait(60s);
    output_ = process.output();
    return code.value_or(-1);
  }
  ScratchFolder folder_;
  std::string output_;
};

TEST_F(DeployCommand, EndsWithZeroWhenEverythingComesAsExpected) {
  EXPECT_EQ(run("[[step]]\nname = \"it runs\"\ndo = \"start all\"\nexpect = \"step > 50\"\nwithin_s = 30\n"),
            0)
      << output_;
  EXPECT_THAT(read_file(folder_ / "out/junit.xml"), HasSubstr("name=\"it runs\" time="));
}

TEST_F(DeployCommand, GoesByTheTransportThatItIsTold) {
  write_file(folder_ / "lan.xml", "not a profile");
  EXPECT_EQ(run("[[step]]\ndo = \"start world\"\n", {"--transport", folder_ / "lan.xml"}), 2);
  EXPECT_THAT(output_, HasSubstr("lan.xml"));
}

TEST_F(DeployCommand, EndsWithThreeWhenAnExpectationIsNotMet) {
  EXPECT_EQ(run("[[step]]\nname = \"it runs\"\ndo = \"start world\"\nexpect = \"step > 50\"\nwithin_s = 1\n"
                "[[step]]\nname = \"never reached\"\n"),
            3)
      << output_;
  const std::string report = read_file(folder_ / "out/junit.xml");
  EXPECT_THAT(report, HasSubstr("failures=\"1\" errors=\"0\" skipped=\"1\""));
  EXPECT_THAT(report, HasSubstr("expected: step &gt; 50"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/world.log")) << "logs are kept";
}

TEST_F(DeployCommand, EndsWithTwoWhenTheScriptIsWrong) {
  EXPECT_EQ(run("[[step]]\ndo = \"explode\"\n"), 2);
  EXPECT_THAT(output_, HasSubstr("script.toml:3"));
}

}  // namespace
}  // namespace caravan::test
