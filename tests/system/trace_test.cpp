// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/support/documented_digest.hpp"
#include "tests/system/support/process.hpp"

namespace caravan {
namespace {

namespace fs = std::filesystem;
using test::kPatience;
using test::Process;
using test::read_file;
using testing::HasSubstr;

class Traces : public testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> words(const std::string& engine, const fs::path& out,
                                               const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all = {"caravan",  "run",     test::scenario("small.toml"),
                                    "--engine", engine,    "--items",
                                    "0",        "--trace", "--out",
                                    out,        "--quiet"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  void run(const std::string& engine, const fs::path& out, const std::vector<std::string>& more = {}) const {
    Process process{words(engine, out, more), folder_ / "run.log"};
    ASSERT_EQ(process.wait(kPatience), 0) << process.output();
  }
  /// The output of `caravan diff` for two runs.
  [[nodiscard]] std::string diff(const fs::path& one, const fs::path& other, int code) const {
    Process process{{"caravan", "diff", one, other}, folder_ / "diff.log"};
    EXPECT_EQ(process.wait(kPatience), code);
    return process.output();
  }

  test::ScratchFolder folder_;
};

std::string digest_of_trace(const fs::path& run) {
  namespace documented = test::documented;
  return documented::digest(
      documented::chain(documented::steps_in(read_file(run / "trace" / "world.trace"))),
      documented::chain(documented::steps_in(read_file(run / "trace" / "radio.trace"))));
}

TEST_F(Traces, OfBothEnginesAreEqualAndGiveTheDigest) {
  const fs::path dds = folder_ / "dds";
  const fs::path embedded = folder_ / "embedded";
  run("dds", dds, {"--max-time", "70"});
  run("embedded", embedded, {"--max-time", "70"});

  const auto digest =
      nlohmann::json::parse(read_file(embedded / "metrics.json"))["digest"].get<std::string>();
  EXPECT_EQ(digest_of_trace(dds), digest);
  EXPECT_EQ(digest_of_trace(embedded), digest);
  EXPECT_EQ(diff(dds, embedded, 0), "equal: 2188 steps, digest " + digest + "\n");
  EXPECT_EQ(read_file(dds / "trace" / "radio.trace"), read_file(embedded / "trace" / "radio.trace"));
}

TEST_F(Traces, NameTheFirstStepRobotAndQuantityThatDiffer) {
  const fs::path one = folder_ / "one";
  const fs::path other = folder_ / "other";
  run("embedded", one, {"--max-time", "10"});
  fs::copy(one, other, fs::copy_options::recursive);
  // Flips the lowest bit of robot 3's y after step 100. A record has 4 bytes of length, 8 of step number, 32
  // of command for each of 4 robots, and 24 of pose for each.
  std::string trace = read_file(other / "trace" / "world.trace");
  const std::size_t record = 4 + 8 + 4 * 56;
  trace[trace.find('\n') + 1 + 99 * record + 4 + 8 + 4 * 32 + 2 * 24 + 8] ^= 1;
  test::write_file(other / "trace" / "world.trace", trace);

  const std::string said = diff(one, other, 1);

  EXPECT_THAT(said, testing::MatchesRegex("step 100 \\(3\\.168 s\\): robot 3 pose\\.y_m: "
                                          "-?[0-9.]+ \\| -?[0-9.]+\n"));
}

TEST_F(Traces, OfDifferentScenariosTellSo) {
  run("embedded", folder_ / "one", {"--max-time", "2"});
  run("embedded", folder_ / "seed", {"--max-time", "2", "--seed", "2"});
  run("embedded", folder_ / "three", {"--max-time", "2", "--robots", "3"});
  run("embedded", folder_ / "long", {"--max-time", "4"});

  const std::string seed = diff(folder_ / "one", folder_ / "seed", 1);
  EXPECT_THAT(seed, HasSubstr("scenario.toml line 2: seed = 1 | seed = 2"));
  EXPECT_THAT(seed, HasSubstr("\nstep 1 (0.000 s): robot 1 command."));
  EXPECT_THAT(diff(folder_ / "one", folder_ / "three", 1), HasSubstr("the runs differ in robots: 4 | 3"));
  EXPECT_THAT(diff(folder_ / "one", folder_ / "long", 1), HasSubstr("equal up to step 63, where"));
}

TEST_F(Traces, OfAKilledRunAreReadUpToTheirLastWholeStep) {
  const fs::path whole = folder_ / "whole";
  const fs::path killed = folder_ / "killed";
  run("embedded", whole, {"--max-time", "30"});
  {
    Process process{words("embedded", killed, {"--max-time", "100000000"}), folder_ / "killed.log"};
    const auto is_longer = [&](const char* name) {
      std::error_code error;
      const auto size = fs::file_size(killed / "trace" / name, error);
      return !error && size > fs::file_size(whole / "trace" / name);
    };
    // Each file is flushed at its own times.
    ASSERT_TRUE(
        test::eventually([&] { return is_longer("world.trace") && is_longer("radio.trace"); }, kPatience));
    process.signal(SIGKILL);
    ASSERT_EQ(process.wait(kPatience), 128 + SIGKILL);
  }

  EXPECT_THAT(diff(whole, killed, 1), HasSubstr("equal up to step 938, where " + whole.string() + " ends"));
  EXPECT_EQ(diff(killed, killed, 0).find("is damaged"), std::string::npos);
}

TEST_F(Traces, ThatAreMissingOrDamagedAreNamedWithExitCodeTwo) {
  const fs::path one = folder_ / "one";
  run("embedded", one, {"--max-time", "1"});
  EXPECT_THAT(diff(one, folder_ / "nowhere", 2), HasSubstr("nowhere/trace/world.trace: cannot be read"));

  const fs::path damaged = folder_ / "damaged";
  fs::copy(one, damaged, fs::copy_options::recursive);
  test::write_file(damaged / "trace" / "radio.trace", "nonsense\n");
  EXPECT_THAT(diff(one, damaged, 2), HasSubstr("is not a radio trace"));
}

}  // namespace
}  // namespace caravan
