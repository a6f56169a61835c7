// SPDX-License-Identifier: Apache-2.0
// One run across three hosts: the world; the radio and 7 agents; 8 agents. With all hosts, and with one cut
// off.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "build_paths.hpp"
#include "tests/system/hosts/fleet.hpp"
#include "tests/system/hosts/network.hpp"
#include "tests/system/support/digest_of.hpp"

namespace caravan::test {
namespace {

using namespace std::chrono_literals;
using ::testing::IsEmpty;

constexpr std::uint32_t kRobots = 15;
constexpr std::uint32_t kOnHost2 = 7;
constexpr auto kCutFor = 5s;

class Hosts : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!network_.refusal().empty()) GTEST_SKIP() << "no network namespaces here: " << network_.refusal();
    const std::string peer = "<locator><udpv4><address>127.0.0.1</address></udpv4></locator>";
    std::string peers;
    for (std::size_t host = 1; host <= 3; ++host)
      peers += replaced(peer, "127.0.0.1", Network::address(host));
    const auto lan = std::filesystem::path{CARAVAN_SOURCE_DIR} / "deploy/fastdds/lan.xml";
    write_file(folder_ / "lan.xml", replaced(read_file(lan), peer, peers));
  }
  /// Starts the small scenario with 15 robots and this number of items.
  void start_everybody(const std::string& items, const std::string& lease_s) {
    std::string text = replaced(read_file(scenario("small.toml")), "count = 4", "count = 15");
    text = replaced(text, "items = 4", "items = " + items);
    write_file(folder_ / "scenario.toml", text);
    fleet_ = std::make_unique<Fleet>(
        folder_ / "scenario.toml",
        std::vector<std::string>{"--domain", "7", "--transport", folder_ / "lan.xml", "--lease", lease_s});
    fleet_->start(on(1), "world_server");
    fleet_->start(on(2), "radio_emulator");
    for (std::uint32_t robot = 1; robot <= kRobots; ++robot) {
      fleet_->start(on(robot <= kOnHost2 ? 2 : 3), "robot_agent", std::to_string(robot));
    }
    ASSERT_TRUE(fleet_->process("world_server").prints("started robots=15", kPatience))
        << fleet_->process("world_server").output();
  }
  [[nodiscard]] Starter on(std::size_t host) {
    return [this, host](std::vector<std::string> arguments, const std::string& log) {
      return network_.start(host, std::move(arguments), log);
    };
  }
  [[nodiscard]] static std::string digest_on_one_host(const std::string& items) {
    return digest_of("small.toml", kEmbedded, {"--robots", "15", "--items", items});
  }

  ScratchFolder folder_;
  Network network_{3, folder_.path()};
  std::unique_ptr<Fleet> fleet_;
};

TEST_F(Hosts, GiveTheDigestOfASingleHost) {
  ASSERT_NO_FATAL_FAILURE(start_everybody("4", "60"));
  Fleet& fleet = *fleet_;
  const std::string digest = fleet.digest(300s);
  EXPECT_EQ(digest, digest_on_one_host("4")) << fleet.process("world_server").output();
  EXPECT_FALSE(fleet.watch(on(1), [](const FleetStatus& now) { return now.answered; }).disturbed);
}

TEST_F(Hosts, CutOffForLessThanTheLeaseOnlyPauseTheRun) {
  ASSERT_NO_FATAL_FAILURE(start_everybody("40", "60"));
  Fleet& fleet = *fleet_;
  // After the first step: in the first, the world continues without a radio that does not come within 10 s.
  const FleetStatus begun = fleet.watch(on(1), [](const FleetStatus& now) { return now.steps > 1; });
  ASSERT_GT(begun.steps, 1U);
  // In wall time, as the lease is, however busy the machine is.
  const auto cut_at = std::chrono::steady_clock::now();
  network_.cut(3);
  (void)eventually([&] { return std::chrono::steady_clock::now() - cut_at > kCutFor; }, kPatience);
  EXPECT_THAT(fleet.digest(0s), IsEmpty()) << "it cannot go on without host 3";
  network_.heal(3);
  EXPECT_EQ(fleet.digest(300s), digest_on_one_host("40")) << fleet.process("world_server").output();
}

class CutOff : public Hosts, public ::testing::WithParamInterface<std::size_t> {};

TEST_P(CutOff, ForLongerThanTheLeaseIsMissedAndTakenBackWhole) {
  const double lease_s = 2.0 * short_lease_s();
  ASSERT_NO_FATAL_FAILURE(start_everybody("100000", std::to_string(lease_s)));
  Fleet& fleet = *fleet_;
  const std::size_t host = GetParam();
  const auto cut_at = std::chrono::steady_clock::now();
  network_.cut(host);
  const auto is_missed = [&](const FleetStatus& now) {
    const auto names = [&](const char* name) { return now.gone.find(name) != std::string::npos; };
    return names(host == 2 ? "robot 7" : "robot 15") && names("radio") == (host != 3);
  };
  const FleetStatus without = fleet.watch(on(1), is_missed);
  EXPECT_TRUE(is_missed(without)) << without.gone;
  // Twice the lease, so that it has run out on both sides of the cut, however busy the machine is.
  const std::chrono::duration<double> cut_for{2.0 * lease_s};
  (void)eventually([&] { return std::chrono::steady_clock::now() - cut_at > cut_for; }, 3 * kPatience);
  network_.heal(host);

  const FleetStatus whole = fleet.watch(on(1), [](const FleetStatus& now) { return is_whole(now, kRobots); });
  EXPECT_TRUE(is_whole(whole, kRobots)) << "members " << whole.members << ", gone " << whole.gone;
  const FleetStatus later = fleet.watch(
      on(1), [&](const FleetStatus& now) { return is_whole(now, kRobots) && now.steps > whole.steps + 200; });
  EXPECT_TRUE(is_whole(later, kRobots)) << "members " << later.members << ", gone " << later.gone;
  EXPECT_GT(later.steps, whole.steps + 200) << "it goes on";
  EXPECT_TRUE(later.disturbed) << "and says what it was";
  EXPECT_THAT(fleet.ended(), IsEmpty()) << "nobody had to be restarted";
}

std::string name_of_host(const ::testing::TestParamInfo<std::size_t>& host) {
  return host.param == 1 ? "World" : host.param == 2 ? "RadioAndSevenAgents" : "EightAgents";
}

INSTANTIATE_TEST_SUITE_P(Each, CutOff, ::testing::Values(1, 2, 3), name_of_host);

}  // namespace
}  // namespace caravan::test
