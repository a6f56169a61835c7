// SPDX-License-Identifier: Apache-2.0
// `caravan ctl` on a running emulation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "runtime/host/domain_lock.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

class ControlCommand : public ::testing::Test {
 protected:
  struct Said {
    int code = -1;
    std::string text;
  };

  [[nodiscard]] Said ctl(std::vector<std::string> words) const {
    std::vector<std::string> line{"caravan", "ctl", "--domain", std::to_string(lock_.domain())};
    line.insert(line.end(), words.begin(), words.end());
    Process process{line, folder_ / "ctl.log"};
    const int code = process.wait(30s).value_or(-1);
    return {code, process.output()};
  }
  /// The number after `words`; -1 if they do not appear.
  static long number_after(const std::string& words, const std::string& text) {
    std::smatch found;
    return std::regex_search(text, found, std::regex{words + " ([0-9]+)"}) ? std::stol(found[1]) : -1;
  }

  runtime::DomainLock lock_{std::nullopt};
  ScratchFolder folder_;
};

TEST_F(ControlCommand, PausesStepsSteersAndDisturbsARun) {
  Process caravan{{"caravan", "run", scenario("small.toml"), "--items", "1000", "--out", folder_ / "out",
                   "--domain", std::to_string(lock_.domain())},
                  folder_ / "caravan.log"};

  const Said paused = ctl({"pause"});
  ASSERT_EQ(paused.code, 0) << paused.text << caravan.output();
  const long at = number_after("done at step", paused.text);
  ASSERT_GT(at, 0) << paused.text;

  EXPECT_EQ(ctl({"step", "5"}).text, "done at step " + std::to_string(at) + "\n");
  const Said cut = ctl({"radio", "cut", "1", "2"});
  EXPECT_EQ(cut.code, 0);
  EXPECT_EQ(cut.text, "scheduled for step " + std::to_string(at + 5) + "\n");
  const Said wall = ctl({"teleport", "1", "0", "0"});
  EXPECT_EQ(wall.code, 1);
  EXPECT_EQ(wall.text, "refused: something solid is there\n");
  EXPECT_EQ(ctl({"spawn", "3", "5", "-5"}).text, "refused: robot 3 is in the world already\n");
  EXPECT_EQ(ctl({"remove", "3"}).code, 0);
  // The status is published twice a second.
  Said removed;
  EXPECT_TRUE(eventually(
      [&] { return (removed = ctl({"status"})).text.find("removed robot 3") != std::string::npos; },
      kPatience))
      << removed.text;
  // The other robots cannot occupy all five places.
  Said teleport;
  for (const std::string x : {"-5", "-4", "-3", "-2", "-1"}) {
    if (teleport.code != 0) teleport = ctl({"teleport", "1", x, "5"});
  }
  EXPECT_EQ(teleport.text, "done at step " + std::to_string(at + 5) + "\n");

  const Said status = ctl({"status"});
  EXPECT_THAT(status.text, HasSubstr("paused"));
  EXPECT_EQ(number_after("steps", status.text), at + 5) << status.text;
  EXPECT_EQ(ctl({"resume"}).code, 0);

  caravan.signal(SIGINT);
  EXPECT_EQ(caravan.wait(10s), 130) << caravan.output();
  EXPECT_TRUE(nlohmann::json::parse(read_file(folder_ / "out/metrics.json")).at("disturbed"));
}

TEST_F(ControlCommand, SaysWhatIsWrongBeforeItAsksAnybody) {
  const Said dance = ctl({"dance"});
  EXPECT_EQ(dance.code, 2);
  EXPECT_THAT(dance.text, HasSubstr("\"dance\" is not a request"));
  const Said later = ctl({"status", "at", "5"});
  EXPECT_EQ(later.code, 2);
  EXPECT_THAT(later.text, HasSubstr("status takes no further words"));
  const Said hold = ctl({"hold"});
  EXPECT_EQ(hold.code, 2);
  EXPECT_THAT(hold.text, HasSubstr("the robot's number is missing"));
}

}  // namespace
}  // namespace caravan::test
