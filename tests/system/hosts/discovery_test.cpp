// SPDX-License-Identifier: Apache-2.0
// Fleets whose processes find each other through a Discovery Server, on 127.0.0.1 only.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "build_paths.hpp"
#include "runtime/bus/fastdds_version.hpp"
#include "runtime/host/domain_lock.hpp"
#include "tests/system/hosts/fleet.hpp"

namespace caravan::test {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::filesystem::path profile(const std::string& name) {
  return std::filesystem::path{CARAVAN_SOURCE_DIR} / "deploy/fastdds" / name;
}

// If a server of Fast DDS 2.9 hears nothing of a newcomer for one lease because the machine is busy, it
// forgets what it has just learned of the newcomer and does not ask again.
constexpr const char* kLease_s = "15";

class DiscoveryServer : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string text = replaced(read_file(profile(runtime::kDiscoveryProfile)), "11811", port_);
    while (text.find("11811") != std::string::npos) text = replaced(text, "11811", port_);
    const std::string name = "<transport_id>discovery</transport_id>";
    write_file(
        folder_ / "discovery.xml",
        replaced(text, name, name + "<interfaceWhiteList><address>127.0.0.1</address></interfaceWhiteList>"));
  }
  void start_server() {
    server_ = std::make_unique<PatientProcess>(
        std::vector<std::string>{"/usr/bin/fast-discovery-server", "-i", "0", "-l", "127.0.0.1", "-p", port_,
                                 "-x", profile("discovery_server.xml")},
        folder_ / "server.log");
    ASSERT_TRUE(server_->prints("Server is running", 30s)) << server_->output();
  }
  void kill_server() {
    server_->signal(SIGKILL);
    ASSERT_TRUE(server_->wait(20s)) << server_->output();
  }
  Fleet& start_fleet(std::uint32_t robots, const std::vector<std::string>& groups) {
    write_file(folder_ / "scenario.toml", replaced(replaced(read_file(scenario("scaling.toml")), "count = 15",
                                                            "count = " + std::to_string(robots)),
                                                   "max_time_s = 600.0", "max_time_s = 360000.0"));
    fleet_ = std::make_unique<Fleet>(
        folder_ / "scenario.toml",
        std::vector<std::string>{"--domain", std::to_string(lock_.domain()), "--transport",
                                 folder_ / "discovery.xml", "--lease", kLease_s});
    fleet_->start(here_, "world_server");
    fleet_->start(here_, "radio_emulator");
    for (const std::string& group : groups) fleet_->start(here_, "robot_agent", group);
    return *fleet_;
  }

  ScratchFolder folder_;
  runtime::DomainLock lock_{std::nullopt};
  // The last port of the domain; no participant uses it.
  const std::string port_ = std::to_string(7400 + 250 * lock_.domain() + 249);
  std::unique_ptr<PatientProcess> server_;
  std::unique_ptr<Fleet> fleet_;
  const Starter here_ = [this](std::vector<std::string> arguments, const std::string& log) {
    arguments[0] = std::string{CARAVAN_BIN_DIR} + "/" + arguments[0];
    return std::make_unique<PatientProcess>(arguments, folder_ / (log + ".log"));
  };
};

TEST_F(DiscoveryServer, JoinsAFleetOfSixty) {
  start_server();
  Fleet& fleet = start_fleet(60, {"1-15", "16-30", "31-45", "46-60"});
  EXPECT_TRUE(fleet.process("world_server").prints("started robots=60", 60s))
      << fleet.process("world_server").output();
}

TEST_F(DiscoveryServer, MayComeAfterTheFleet) {
  Fleet& fleet = start_fleet(4, {"1-2", "3-4"});
  ASSERT_TRUE(fleet.process("robot_agent", "1-2").prints("waiting for the world", 30s));
  start_server();
  EXPECT_TRUE(fleet.process("world_server").prints("started robots=4", 60s))
      << fleet.process("world_server").output();
}

TEST_F(DiscoveryServer, MayBeGoneForAWhile) {
  start_server();
  Fleet& fleet = start_fleet(6, {"1-2", "3-4", "5-6"});
  ASSERT_TRUE(fleet.process("world_server").prints("started robots=6", 60s));
  const auto before = fleet.watch(here_, [](const FleetStatus& now) { return now.answered; });

  const auto down_at = std::chrono::steady_clock::now();
  kill_server();
  // Longer than the lease that the server announces, as the service unit does.
  (void)eventually([&] { return std::chrono::steady_clock::now() - down_at > 5s; }, 20s);
  EXPECT_THAT(fleet.ended(), IsEmpty());
  start_server();

  const auto after = fleet.watch(here_, [](const FleetStatus& now) { return is_whole(now, 6); });
  EXPECT_TRUE(is_whole(after, 6)) << "a newcomer finds everybody, and nobody was lost: members "
                                  << after.members << ", gone " << after.gone;
  EXPECT_GT(after.steps, before.steps + 50) << "the run went on";
  EXPECT_FALSE(after.disturbed);

  fleet.kill("robot_agent", "1-2");
  const auto missed = fleet.watch(
      here_, [](const FleetStatus& now) { return now.gone.find("robot 2") != std::string::npos; });
  EXPECT_THAT(missed.gone, HasSubstr("robot 2")) << "the new server tells who is gone";
  fleet.start(here_, "robot_agent", "1-2");
  const auto back = fleet.watch(here_, [](const FleetStatus& now) { return is_whole(now, 6); });
  EXPECT_TRUE(is_whole(back, 6)) << "members " << back.members << ", gone " << back.gone;
}

}  // namespace
}  // namespace caravan::test
