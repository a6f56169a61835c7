// SPDX-License-Identifier: Apache-2.0
// The DDS profiles of deploy/fastdds, by --transport.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "build_paths.hpp"
#include "runtime/bus/fastdds_version.hpp"
#include "runtime/bus/shared_memory_port.hpp"
#include "runtime/host/domain_lock.hpp"
#include "tests/system/hosts/network.hpp"
#include "tests/system/support/digest_of.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::Not;

std::filesystem::path profile(const std::string& name) {
  return std::filesystem::path{CARAVAN_SOURCE_DIR} / "deploy/fastdds" / name;
}

class Profile : public ::testing::Test {
 protected:
  /// The output of a program started with this transport, which it must refuse.
  [[nodiscard]] std::string refusal(const std::string& transport) const {
    Process agent{{"robot_agent", "--scenario", scenario("small.toml"), "--robot", "1", "--domain",
                   std::to_string(lock_.domain()), "--transport", transport},
                  folder_ / "agent.log"};
    EXPECT_EQ(agent.wait(30s), 2) << transport << ": " << agent.output();
    return agent.output();
  }
  runtime::DomainLock lock_{std::nullopt};
  ScratchFolder folder_;
};

TEST_F(Profile, OfASingleHostIsWhatIsDoneWithoutOne) {
  Process world{{"world_server", "--scenario", scenario("small.toml"), "--domain",
                 std::to_string(lock_.domain()), "--transport", profile("single_host.xml")},
                folder_ / "world.log"};
  Process ctl{{"caravan", "ctl", "--domain", std::to_string(lock_.domain()), "status"}, folder_ / "ctl.log"};
  EXPECT_EQ(ctl.wait(30s), 0) << ctl.output();
  EXPECT_THAT(ctl.output(), HasSubstr("waiting")) << "it speaks with one that was told nothing";
  EXPECT_THAT(read_file("/proc/" + std::to_string(world.pid()) + "/maps"),
              HasSubstr("/dev/shm/" + runtime::shared_memory_mark()));
  world.signal(SIGTERM);
  EXPECT_EQ(world.wait(20s), 0) << world.output();
}

TEST_F(Profile, OfALanGivesTheSameRun) {
  const std::string mark = "<transport_id>lan</transport_id>";
  write_file(folder_ / "lan.xml",
             replaced(read_file(profile("lan.xml")), mark,
                      mark + "<interfaceWhiteList><address>127.0.0.1</address></interfaceWhiteList>"));
  const std::vector<std::string> few{"--items", "1"};
  EXPECT_EQ(digest_of("small.toml", {"--transport", folder_ / "lan.xml"}, few),
            digest_of("small.toml", kEmbedded, few));
}

TEST_F(Profile, ThatIsNoneIsRefused) {
  EXPECT_THAT(refusal("carrier-pigeon"), HasSubstr("carrier-pigeon"));
  EXPECT_THAT(refusal("/nowhere/lan.xml"), HasSubstr("no such file: /nowhere/lan.xml"));
  write_file(folder_ / "torn.xml", "<dds><profiles>");
  EXPECT_THAT(refusal(folder_ / "torn.xml"), HasSubstr("torn.xml: not a Fast DDS profile file"));
  write_file(folder_ / "odd.xml",
             replaced(read_file(profile("lan.xml")), "<useBuiltinTransports>", "<useCarrierPigeons>"));
  EXPECT_THAT(refusal(folder_ / "odd.xml"), HasSubstr("odd.xml: not a Fast DDS profile file"));
  write_file(folder_ / "other.xml",
             replaced(read_file(profile("lan.xml")), "profile_name=\"caravan\"", "profile_name=\"other\""));
  EXPECT_THAT(refusal(folder_ / "other.xml"),
              HasSubstr("other.xml: no participant profile named \"caravan\""));
}

TEST_F(Profile, IsLookedAtByTheDoctor) {
  Process good{{"caravan", "doctor", "--domain", "9", "--transport", profile("ros2.xml")}, folder_ / "log"};
  EXPECT_TRUE(good.wait(30s));
  EXPECT_THAT(good.output(), HasSubstr("needs no server"));
  EXPECT_THAT(good.output(), HasSubstr("shared memory   not used by this transport"));
  const std::string mark = "<transport_id>discovery</transport_id>";
  const std::string elsewhere = "<interfaceWhiteList><address>192.0.2.1</address></interfaceWhiteList>";
  std::string text = read_file(profile(runtime::kDiscoveryProfile));
  text = replaced(replaced(text, mark, mark + elsewhere), "<port>11811", "<port>9");
  write_file(folder_ / "discovery.xml", text);
  Process bad{{"caravan", "doctor", "--domain", "9", "--transport", folder_ / "discovery.xml"},
              folder_ / "log"};
  EXPECT_EQ(bad.wait(30s), 1) << bad.output();
  EXPECT_THAT(bad.output(), HasSubstr("no Discovery Server at 127.0.0.1:9"));
  EXPECT_THAT(bad.output(), HasSubstr("not an address of this host: 192.0.2.1"));
  Process none{{"caravan", "doctor", "--transport", "/nowhere/lan.xml"}, folder_ / "log"};
  EXPECT_EQ(none.wait(30s), 2) << none.output();
}

/// A DDS program that does not use our bus receives the clock on another host, with the discovery that ROS 2
/// uses.
TEST_F(Profile, OfRos2NeighboursIsHeardByAForeignProgramOnTheNetwork) {
  Network network{2, folder_.path()};
  if (!network.refusal().empty()) GTEST_SKIP() << "no network namespaces here: " << network.refusal();
  const auto neighbour = network.start(2, {CARAVAN_NEIGHBOUR, "7"}, "neighbour");
  std::vector<std::unique_ptr<PatientProcess>> ours;
  const std::vector<std::string> common{"--scenario", scenario("small.toml"), "--domain",
                                        "7",          "--transport",          profile("ros2.xml")};
  for (std::vector<std::string> line :
       {std::vector<std::string>{"world_server"}, {"radio_emulator"}, {"robot_agent", "--robots", "1-4"}}) {
    line.insert(line.end(), common.begin(), common.end());
    ours.push_back(network.start(1, line, line[0]));
  }
  EXPECT_EQ(neighbour->wait(60s), 0) << neighbour->output() << ours[0]->output();
  EXPECT_THAT(neighbour->output(), HasSubstr("heard the clock"));
}

}  // namespace
}  // namespace caravan::test
