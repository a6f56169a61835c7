// SPDX-License-Identifier: Apache-2.0
// docs/other_vendors.md, carried out as written: a robot whose agent uses Cyclone DDS takes part in the
// lockstep.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <regex>
#include <sstream>

#include "build_paths.hpp"
#include "runtime/host/domain_lock.hpp"
#include "tests/system/support/bus_player.hpp"
#include "tests/system/vendors/snippets.hpp"

namespace caravan::test {
namespace {

namespace msg = caravan_interfaces::msg;

/// The rule of the page's agent on our own bus. Equal answers give equal runs.
class SameAgent {
 public:
  explicit SameAgent(const runtime::BusConfig& config) : bus_{config} {
    commands_ = bus_.writer<msg::RobotCommandPubSubType>(idl::kCommand, 1);
    transmits_ = bus_.writer<msg::RadioTransmitPubSubType>(idl::kRadioTransmit, 1);
    bus_.reader<msg::SensorFramePubSubType>(
        idl::kSensors, 1, [this](const msg::SensorFrame& frame, const auto&) { answer(frame); });
  }

 private:
  void answer(const msg::SensorFrame& frame) {
    const auto& ranges = frame.sonar_range_m();
    const bool is_near = std::any_of(&ranges[2], &ranges[6], [](double range_m) { return range_m < 1.0; });
    msg::RobotCommand command;
    command.stamp(frame.stamp());
    command.session(frame.session());
    command.left_mps(is_near ? 0.2 : 0.4);
    command.right_mps(is_near ? -0.2 : 0.4);
    commands_.write(command);
    msg::RadioTransmit silence;
    silence.stamp(frame.stamp());
    silence.session(frame.session());
    transmits_.write(silence);
  }

  runtime::Writer<msg::RobotCommandPubSubType> commands_;
  runtime::Writer<msg::RadioTransmitPubSubType> transmits_;
  runtime::Bus bus_;
};

class Cyclone : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* needed : {"/usr/bin/idlc", "/usr/include/dds/dds.h", "/usr/bin/cc"}) {
      if (!std::filesystem::exists(needed)) {
        GTEST_SKIP() << "no " << needed << " here (Debian: cyclonedds-dev, cyclonedds-tools)";
      }
    }
    std::filesystem::create_symlink(std::filesystem::path{CARAVAN_SOURCE_DIR} / "idl", folder_ / "idl");
    for (const Snippet& snippet : snippets_of(CARAVAN_SOURCE_DIR "/docs/other_vendors.md")) {
      ASSERT_NE(snippet.file, "") << "nobody would build this:\n" << snippet.text;
      if (snippet.language == "sh") {
        commands_[snippet.file] = snippet.text;
      } else {
        write_file(folder_ / snippet.file, snippet.text);
      }
    }
  }
  /// Runs a command line of the page as if typed in the folder with its files, but in this domain.
  [[nodiscard]] std::unique_ptr<PatientProcess> typed(const std::string& line, const std::string& log) const {
    const std::string domain = std::to_string(lock_.domain());
    std::string command = std::regex_replace(line, std::regex{"(--domain|/agent) 7"}, "$1 " + domain);
    if (command != line && line.find("--domain") != std::string::npos) command += " --lease 60";
    const std::string path = std::string{CARAVAN_BIN_DIR} + ":/usr/bin:/bin";
    return std::make_unique<PatientProcess>(
        std::vector<std::string>{
            "/bin/sh", "-c", "cd " + folder_.path().string() + " && exec env PATH=" + path + " " + command},
        folder_ / (log + ".log"));
  }
  void build() {
    const auto built = typed("sh -ec '" + commands_.at("build") + "'", "build");
    ASSERT_EQ(built->wait(kPatience), 0) << built->output();
    ASSERT_EQ(built->output(), "") << "a compiler warns";
  }
  /// Runs our programs with one more agent. @return the digest that the world reports; empty if the run does
  /// not end
  template <typename Agent>
  std::string digest_with(Agent start_agent) {
    std::istringstream lines{commands_.at("run")};
    std::map<std::string, std::unique_ptr<PatientProcess>> processes;
    for (std::string line; std::getline(lines, line);) {
      const std::string program = line.substr(0, line.find(' '));
      if (line.find("/agent") == std::string::npos) processes[program] = typed(line, program);
    }
    const auto agent = start_agent();
    const auto end = Collector<msg::WorldStatusPubSubType>{config_, idl::kWorldStatus}.first(
        [](const msg::WorldStatus& status) {
          return status.state() == msg::WorldStatus_Constants::FINISHED;
        });
    EXPECT_TRUE(end) << processes.at("world_server")->output();
    finish(*agent);
    for (auto& [name, process] : processes) {
      process->signal(SIGTERM);
      EXPECT_EQ(process->wait(kPatience), 0) << name << process->output();
    }
    if (!end) return "";
    EXPECT_FALSE(end->disturbed());
    return end->digest();
  }
  void finish(const SameAgent&) {}
  void finish(PatientProcess& agent) {
    EXPECT_EQ(agent.wait(kPatience), 0) << agent.output();
    agent_said_ = agent.output();
  }

  runtime::DomainLock lock_{std::nullopt};
  ScratchFolder folder_;
  const runtime::BusConfig config_{
      .role = "test", .domain = lock_.domain(), .lease_s = 60.0, .transport = runtime::Transport::kUdp};
  std::map<std::string, std::string> commands_;
  std::string agent_said_;
};

TEST_F(Cyclone, AnAgentOfAnotherVendorDrivesARobotInLockstepAndReadsTheTruth) {
  ASSERT_NO_FATAL_FAILURE(build());
  std::istringstream run{commands_.at("run")};
  std::string agent;
  for (std::string line; std::getline(run, line);) {
    if (line.find("/agent") != std::string::npos) agent = line;
  }
  ASSERT_NE(agent, "");
  const Collector<msg::WorldTruthPubSubType> truths{config_, idl::kTruth};

  const std::string digest = digest_with([&] { return typed(agent, "agent"); });

  const auto last = truths.first([](const msg::WorldTruth& truth) { return truth.last(); });
  ASSERT_TRUE(last);
  const msg::RobotTruth& robot = last->robots().at(0);
  std::array<char, 160> expected{};
  std::snprintf(expected.data(), expected.size(), "robot 1: 625 steps, ends at %.17g %.17g\n", robot.x_m(),
                robot.y_m());
  EXPECT_EQ(agent_said_, expected.data()) << "every frame, and the truth bit for bit";
  const auto first = truths.samples().front();
  const double way_m =
      std::hypot(robot.x_m() - first.robots().at(0).x_m(), robot.y_m() - first.robots().at(0).y_m());
  EXPECT_GT(way_m, 1.0) << "it moves as it was told";

  EXPECT_EQ(digest, digest_with([&] { return std::make_unique<SameAgent>(config_); }))
      << "the run does not depend on whose DDS the agent speaks";
}

}  // namespace
}  // namespace caravan::test
