// SPDX-License-Identifier: Apache-2.0
// Runs on a full disk: a small file system in a mount namespace.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "build_paths.hpp"
#include "runtime/host/domain_lock.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::chrono::milliseconds kPatience{100'000};
constexpr const char* kFull = "No space left on device";

class FullDisk : public ::testing::Test {
 protected:
  /// The words that run a command with a file system of this size mounted at disk(). `before` enters the
  /// namespace. Since the namespace ends with the command, the files are then copied to kept().
  [[nodiscard]] std::vector<std::string> with_disk(const std::vector<std::string>& before,
                                                   const std::string& size) const {
    std::vector<std::string> line = before;
    const std::string work = "mount -t tmpfs -o size=" + size + " tmpfs " + disk() +
                             " || exit 77; timeout -s KILL 120 \"$@\"; code=$?; cp -r " + disk() + " " +
                             kept() + "; exit $code";
    line.insert(line.end(), {"/bin/sh", "-c", work, "full_disk"});
    return line;
  }
  void SetUp() override {
    std::filesystem::create_directory(disk());
    for (const std::vector<std::string>& before :
         {std::vector<std::string>{"/usr/bin/unshare", "--mount"},
          std::vector<std::string>{"/usr/bin/unshare", "--user", "--map-root-user", "--mount"}}) {
      std::vector<std::string> line = with_disk(before, "64k");
      line.emplace_back("/bin/true");
      PatientProcess trial{line, folder_ / "trial.log"};
      const bool works = trial.wait(kPatience) == 0;
      std::filesystem::remove_all(kept());
      if (works) {
        before_ = before;
        return;
      }
      refusal_ = trial.output();
    }
    GTEST_SKIP() << "no disk of its own can be made here: " << refusal_;
  }
  /// Runs `caravan run` with its results on a file system of this size. @return its exit code
  std::optional<int> run(const std::string& size, const std::vector<std::string>& options) {
    std::vector<std::string> line = with_disk(before_, size);
    line.insert(line.end(), {std::string{CARAVAN_BIN_DIR} + "/caravan", "run", scenario("small.toml"),
                             "--quiet", "--items", "100000", "--max-time", "100000", "--out", disk() + "/out",
                             "--domain", std::to_string(domain_)});
    line.insert(line.end(), options.begin(), options.end());
    PatientProcess caravan{line, folder_ / "caravan.log"};
    const auto code = caravan.wait(kPatience);
    said_ = caravan.output();
    return code;
  }
  [[nodiscard]] std::string disk() const { return folder_ / "disk"; }
  [[nodiscard]] std::string kept() const { return folder_ / "kept"; }
  [[nodiscard]] std::string kept(const std::string& name) const {
    return read_file(folder_.path() / "kept/out" / name);
  }
  /// Expects a header and whole rows.
  void expect_whole_rows(const std::string& name) const {
    SCOPED_TRACE(name);
    std::istringstream rows{kept(name)};
    std::string row;
    ASSERT_TRUE(std::getline(rows, row));
    const auto commas = std::count(row.begin(), row.end(), ',');
    while (std::getline(rows, row)) EXPECT_EQ(std::count(row.begin(), row.end(), ','), commas) << row;
    EXPECT_TRUE(kept(name).ends_with("\n"));
  }
  void expect_a_readable_record() const {
    for (const char* name : {"tracks.csv", "trips.csv", "events.csv", "activities.csv", "path_lengths.csv"})
      expect_whole_rows(name);
    const auto metrics = nlohmann::json::parse(kept("metrics.json"));
    EXPECT_TRUE(metrics.at("ended"));
    EXPECT_FALSE(metrics.at("completed"));
    EXPECT_THAT(metrics.at("failure"), HasSubstr(kept_reason_));
    EXPECT_GT(metrics.at("sim_time_s"), 1.0);
    EXPECT_THAT(said_, HasSubstr(metrics.at("failure").get<std::string>()));
  }

  ScratchFolder folder_;
  std::vector<std::string> before_;
  std::string refusal_;
  std::string said_;
  /// Below the domains that a run chooses from. The test cannot hold a lock on it: a shell stands between the
  /// test and the run, so the run could not take over the domain.
  std::uint32_t domain_ = 1 + static_cast<std::uint32_t>(getpid()) % 99;
  std::string kept_reason_ = kFull;
};

TEST_F(FullDisk, EndsARunThatSaysWhereAndWhyAndLeavesAWholeRecord) {
  EXPECT_EQ(run("140k", {}), 1) << said_;
  EXPECT_THAT(said_, HasSubstr(kFull));
  EXPECT_THAT(said_, HasSubstr("make room there and start again"));
  EXPECT_EQ(said_.find(kFull), said_.rfind(kFull)) << "told once: " << said_;
  expect_a_readable_record();
  EXPECT_THAT(processes_in(domain_), IsEmpty());
  EXPECT_THAT(left_in_shared_memory(domain_), IsEmpty());
}

TEST_F(FullDisk, EndsARunOfTheEmbeddedEngineInTheSameWay) {
  EXPECT_EQ(run("160k", {"--engine", "embedded"}), 1) << said_;
  EXPECT_EQ(std::count(said_.begin(), said_.end(), '\n'), 1) << "one line: " << said_;
  expect_a_readable_record();
}

/// World and radio each write a part of the trace. A process that cannot write ends, and the run with it.
TEST_F(FullDisk, EndsARunWhoseTraceCannotGoOnAndTheTraceCanBeRead) {
  std::vector<std::string> options;
  options.emplace_back("--trace");
  EXPECT_EQ(run("400k", options), 1) << said_;
  EXPECT_THAT(said_, ::testing::AnyOf(HasSubstr(kFull), HasSubstr("no space is left in " + disk())));
  kept_reason_ = "";
  expect_a_readable_record();
  const std::string out = folder_.path() / "kept/out";
  Process diff{{"caravan", "diff", out, out}, folder_ / "diff.log"};
  EXPECT_EQ(diff.wait(kPatience), 0) << diff.output();
  EXPECT_THAT(processes_in(domain_), IsEmpty());
  EXPECT_THAT(left_in_shared_memory(domain_), IsEmpty());
}

TEST_F(FullDisk, RefusesToStartWhereThereIsNoRoomAtAll) {
  for (const std::string engine : {"dds", "embedded"}) {
    SCOPED_TRACE(engine);
    std::filesystem::remove_all(kept());
    EXPECT_EQ(run("12k", {"--engine", engine}), 2) << said_;
    EXPECT_THAT(said_, HasSubstr(kFull));
  }
}

/// Only the trace cannot be written: it reaches the limit on the size of files long before the other files.
class FullTrace : public ::testing::Test {
 protected:
  /// SIGXFSZ is ignored, so that a write beyond the limit fails instead of killing the process.
  [[nodiscard]] std::vector<std::string> run(const std::string& before,
                                             const std::vector<std::string>& options) const {
    std::vector<std::string> line{"/bin/sh",
                                  "-c",
                                  "trap '' XFSZ; " + before + " exec \"$@\"",
                                  "full_trace",
                                  std::string{CARAVAN_BIN_DIR} + "/caravan",
                                  "run",
                                  scenario("small.toml"),
                                  "--quiet",
                                  "--trace",
                                  "--items",
                                  "100000",
                                  "--max-time",
                                  "100000",
                                  "--out",
                                  folder_ / "out"};
    line.insert(line.end(), options.begin(), options.end());
    return line;
  }
  [[nodiscard]] std::string failure() const {
    return nlohmann::json::parse(read_file(folder_ / "out/metrics.json")).at("failure");
  }
  ScratchFolder folder_;
};

TEST_F(FullTrace, EndsAnEmbeddedRun) {
  PatientProcess caravan{run("ulimit -f 500;", {"--engine", "embedded"}), folder_ / "caravan.log"};
  EXPECT_EQ(caravan.wait(kPatience), 1) << caravan.output();
  EXPECT_THAT(failure(), ::testing::ContainsRegex("\\.trace: cannot be written: File too large"));
  EXPECT_THAT(caravan.output(), HasSubstr(failure()));
}

/// The world could continue without its radio, but half of the trace would be missing.
TEST_F(FullTrace, OfTheRadioEndsTheRun) {
  const runtime::DomainLock lock{std::nullopt};
  PatientProcess caravan{run("", {"--domain", std::to_string(lock.domain())}), folder_ / "caravan.log"};
  const auto trace = folder_ / "out/trace/radio.trace";
  ASSERT_TRUE(eventually(
      [&] {
        std::error_code error;
        return std::filesystem::file_size(trace, error) > 50'000 && !error;
      },
      kPatience))
      << caravan.output();
  const auto all = processes_in(lock.domain());
  const auto radio = std::find_if(all.begin(), all.end(), [](pid_t pid) {
    return read_file("/proc/" + std::to_string(pid) + "/comm").starts_with("radio_emulator");
  });
  ASSERT_NE(radio, all.end());
  const rlimit limit{60'000, RLIM_INFINITY};
  ASSERT_EQ(prlimit(*radio, RLIMIT_FSIZE, &limit, nullptr), 0);

  EXPECT_EQ(caravan.wait(kPatience), 1) << caravan.output();

  EXPECT_THAT(failure(), HasSubstr("radio_emulator"));
  EXPECT_THAT(read_file(folder_ / "out/logs/radio_emulator.log"),
              HasSubstr("radio.trace: cannot be written: File too large"));
  EXPECT_THAT(processes_in(lock.domain()), IsEmpty());
}

TEST(FullDiskOfAScript, IsToldWhenItsReportCannotBeWritten) {
  const ScratchFolder folder;
  write_file(folder / "empty.toml",
             "name = \"nothing\"\nscenario = \"" + scenario("small.toml").string() +
                 "\"\n[[step]]\nname = \"nothing runs\"\nexpect = \"state is absent\"\n");
  Process deploy{
      {"caravan", "deploy", folder / "empty.toml", "--out", folder / "logs", "--junit", "/dev/full"},
      folder / "deploy.log"};
  EXPECT_EQ(deploy.wait(kPatience), 1) << deploy.output();
  EXPECT_THAT(deploy.output(), HasSubstr("/dev/full: cannot be written: No space left on device"));
}

}  // namespace
}  // namespace caravan::test
