// SPDX-License-Identifier: Apache-2.0
#include "deploy/launcher/run_commands.hpp"

#include <gmock/gmock.h>

namespace caravan::deploy {
namespace {

using testing::ElementsAre;

std::vector<std::string> texts_of(const std::vector<RobotGroup>& groups) {
  std::vector<std::string> words;
  for (const RobotGroup& group : groups) words.push_back(to_text(group));
  return words;
}

TEST(RobotGroups, HaveEachRobotOnceAndTheLastMayBeSmaller) {
  EXPECT_THAT(texts_of(groups_of(3, 1)), ElementsAre("1", "2", "3"));
  EXPECT_THAT(texts_of(groups_of(6, 4)), ElementsAre("1-4", "5-6"));
  EXPECT_THAT(texts_of(groups_of(5, 4)), ElementsAre("1-4", "5"));
  EXPECT_THAT(texts_of(groups_of(2, 16)), ElementsAre("1-2"));
}

TEST(RunCommands, TellEveryProcessScenarioDomainLeaseAndTransport) {
  const RunSetup run{.binaries = "/bin",
                     .scenario = "a.toml",
                     .domain = 7,
                     .transport = runtime::Transport::kUdp,
                     .lease_s = 2.0};
  const auto with_common = [](const std::string& program, std::vector<std::string> more) {
    std::vector<std::string> line{program,   "--scenario", "a.toml",      "--domain", "7",
                                  "--lease", "2.000000",   "--transport", "udp"};
    line.insert(line.end(), more.begin(), more.end());
    return line;
  };

  EXPECT_EQ(world_command(run, "kit"), with_common("/bin/world_server", {"--await", "kit"}));
  EXPECT_EQ(radio_command(run), with_common("/bin/radio_emulator", {}));
  EXPECT_EQ(agent_command(run, "3"), with_common("/bin/robot_agent", {"--robot", "3"}));
  EXPECT_EQ(agent_command(run, "1-4"), with_common("/bin/robot_agent", {"--robots", "1-4"}));
}

}  // namespace
}  // namespace caravan::deploy
