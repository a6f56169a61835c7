// SPDX-License-Identifier: Apache-2.0
// Standard streams that are closed or whose reader has left: the records of the run are complete.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "build_paths.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr std::chrono::seconds kPatience{100};

class ClosedStreams : public ::testing::TestWithParam<const char*> {
 protected:
  /// Runs the small scenario in a shell with this redirection, and checks its records.
  void expect_whole_record(const std::string& redirection) {
    const std::string line = std::string{CARAVAN_BIN_DIR} + "/caravan run " +
                             scenario("small.toml").string() + " --engine " + GetParam() + " --out " +
                             (folder_ / "out").string() + redirection;
    deploy::Process shell{{"/bin/sh", "-c", line}, folder_ / "shell.log"};
    EXPECT_EQ(shell.wait(kPatience), 0) << shell.output();
    const auto metrics = nlohmann::json::parse(read_file(folder_ / "out/metrics.json"));
    EXPECT_TRUE(metrics.at("ended"));
    EXPECT_TRUE(metrics.at("completed"));
    EXPECT_EQ(metrics.at("digest"), "11507217511ba8df");
    const std::pair<const char*, const char*> firsts[] = {
        {"tracks.csv", "time_s,robot,"}, {"events.csv", "time_s,robot,"}, {"trips.csv", "robot,trip,"}};
    for (const auto& [file, first] : firsts) {
      const std::string text = read_file(folder_ / (std::string{"out/"} + file));
      EXPECT_THAT(text, StartsWith(first));
      EXPECT_EQ(text.back(), '\n') << file;
      EXPECT_THAT(text, ::testing::Not(HasSubstr("DDS domain"))) << file;
    }
  }

  ScratchFolder folder_;
};

TEST_P(ClosedStreams, AReaderThatLeavesAfterTheFirstLineDoesNotEndTheRun) {
  expect_whole_record(" | head -1");
}

TEST_P(ClosedStreams, AReaderThatReadsNothingDoesNotEndTheRun) { expect_whole_record(" 2>&1 | true"); }

TEST_P(ClosedStreams, NoStreamAtAllLeavesTheRecordsFreeOfWhatIsPrinted) {
  expect_whole_record(" <&- >&- 2>&-");
}

class FullOutput : public ::testing::TestWithParam<const char*> {};

TEST_P(FullOutput, IsAnErrorWithOneLine) {
  const ScratchFolder folder;
  const std::string line =
      "cd " + folder.path().string() + " && " + CARAVAN_BIN_DIR + "/" + GetParam() + " > /dev/full";
  deploy::Process shell{{"/bin/sh", "-c", line}, folder / "shell.log"};
  EXPECT_EQ(shell.wait(kPatience), 1) << shell.output();
  EXPECT_THAT(shell.output(), HasSubstr("standard output: not all that was printed could be written"));
}

INSTANTIATE_TEST_SUITE_P(Command, FullOutput,
                         ::testing::Values("caravan run " CARAVAN_SOURCE_DIR
                                           "/deploy/scenarios/small.toml --engine embedded --out out",
                                           "caravan check " CARAVAN_SOURCE_DIR "/deploy/scenarios/small.toml",
                                           "caravan --help", "world_server --help", "robot_agent --version",
                                           "radio_emulator --check-config --scenario " CARAVAN_SOURCE_DIR
                                           "/deploy/scenarios/small.toml"),
                         [](const auto& one) { return "Number" + std::to_string(one.index); });

INSTANTIATE_TEST_SUITE_P(Engine, ClosedStreams, ::testing::Values("embedded", "dds"),
                         [](const auto& engine) { return std::string{engine.param}; });

}  // namespace
}  // namespace caravan::test
