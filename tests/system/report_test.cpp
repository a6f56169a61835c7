// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tests/system/support/process.hpp"

namespace caravan {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using test::Process;
using test::read_file;

TEST(Report, IsDrawnAtTheEndOfARunThatAsksForItAndAgainByTheCommand) {
  const test::ScratchFolder folder;
  const fs::path run = folder / "run";
  Process running{
      {"caravan", "run", test::scenario("small.toml"), "--engine", "embedded", "--out", run, "--report"},
      folder / "run.log"};
  ASSERT_EQ(running.wait(120s), 0) << running.output();
  EXPECT_THAT(running.output(), testing::HasSubstr((run / "report/report.html").string()));

  Process drawing{{"caravan", "report", run, "--out", folder / "again"}, folder / "report.log"};
  ASSERT_EQ(drawing.wait(120s), 0) << drawing.output();

  for (const fs::path& report : {run / "report", folder / "again"}) {
    EXPECT_THAT(read_file(report / "report.html"), testing::HasSubstr("<svg"));
    EXPECT_GT(fs::file_size(report / "figures/items_over_time.png"), 5000U);
    EXPECT_GT(fs::file_size(report / "figures/items_over_time.svg"), 5000U);
  }
}

TEST(Report, OfNothingEndsWithAnError) {
  const test::ScratchFolder folder;
  Process drawing{{"caravan", "report", folder / "nowhere"}, folder / "report.log"};
  EXPECT_EQ(drawing.wait(60s), 1);
  EXPECT_THAT(drawing.output(), testing::HasSubstr("nowhere: is no folder"));
}

}  // namespace
}  // namespace caravan
