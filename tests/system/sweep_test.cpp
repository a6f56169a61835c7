// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <signal.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "build_paths.hpp"
#include "tests/system/support/process.hpp"

namespace caravan {
namespace {

namespace fs = std::filesystem;
using test::eventually;
using test::kPatience;
using test::Process;
using test::read_file;
using testing::HasSubstr;

/// 2 modes x 2 seeds of the small scenario, one at a time.
std::vector<std::string> small_sweep(const fs::path& out, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {"caravan",   "sweep",  test::scenario("small.toml"),
                                    "--seeds",   "1-2",    "--modes",
                                    "none,full", "--jobs", "1",
                                    "--items",   "0",      "--max-time",
                                    "100",       "--out",  out};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

nlohmann::json state_of(const fs::path& out) { return nlohmann::json::parse(read_file(out / "sweep.json")); }

std::size_t count_in(const fs::path& out, const std::string& state) {
  if (!fs::exists(out / "sweep.json")) return 0;
  std::size_t count = 0;
  const nlohmann::json sweep = state_of(out);
  for (const auto& run : sweep["runs"]) count += run["state"] == state ? 1U : 0U;
  return count;
}

/// The running process that writes to this folder; 0 if there is none.
pid_t runner_of(const fs::path& folder) {
  const std::string wanted = std::string{"--out"} + '\0' + folder.string() + '\0';
  for (const auto& entry : fs::directory_iterator{"/proc"}) {
    const pid_t pid = static_cast<pid_t>(std::strtol(entry.path().filename().c_str(), nullptr, 10));
    if (pid <= 0) continue;
    const std::string line = read_file(entry.path() / "cmdline");
    if (line.find(wanted) != std::string::npos && line.find(std::string{"run"} + '\0') != std::string::npos)
      return pid;
  }
  return 0;
}

TEST(Sweep, ThatWasInterruptedGoesOnToTheSameSummary) {
  const test::ScratchFolder folder;
  const fs::path whole = folder / "whole";
  const fs::path parts = folder / "parts";
  Process uninterrupted{small_sweep(whole), folder / "whole.log"};
  ASSERT_EQ(uninterrupted.wait(kPatience), 0) << uninterrupted.output();

  for (const int number : {SIGINT, SIGKILL}) {
    const std::size_t before = count_in(parts, "done");
    Process process{small_sweep(parts), folder / "parts.log"};
    ASSERT_TRUE(eventually([&] { return count_in(parts, "done") > before; }, kPatience));
    process.signal(number);
    EXPECT_EQ(process.wait(kPatience), number == SIGINT ? 130 : 128 + SIGKILL);
    EXPECT_LT(count_in(parts, "done"), 4U) << "nothing is left to go on with";
    EXPECT_EQ(state_of(parts)["state"], number == SIGINT ? "unfinished" : "running");
  }
  const std::string first_run = read_file(parts / "none" / "seed_1" / "metrics.json");
  Process rest{small_sweep(parts), folder / "rest.log"};

  EXPECT_EQ(rest.wait(kPatience), 0) << rest.output();
  EXPECT_THAT(rest.output(), HasSubstr("2 done and 0 failed before"));
  EXPECT_EQ(read_file(parts / "none" / "seed_1" / "metrics.json"), first_run) << "done again";
  EXPECT_EQ(read_file(parts / "summary.csv"), read_file(whole / "summary.csv"));
  EXPECT_EQ(read_file(parts / "sweep.json"), read_file(whole / "sweep.json"));
}

TEST(Sweep, ARunThatCrashesStaysInTheTableMarkedAndIsDoneAgainOnDemand) {
  const test::ScratchFolder folder;
  const fs::path out = folder / "out";
  {
    Process process{small_sweep(out), folder / "log"};
    pid_t runner = 0;
    ASSERT_TRUE(eventually([&] { return (runner = runner_of(out / "none" / "seed_2")) > 0; }, kPatience));
    kill(runner, SIGSEGV);

    EXPECT_EQ(process.wait(kPatience), 1);
    EXPECT_THAT(process.output(), HasSubstr("failed: mode none seed 2: killed by signal 11"));
  }
  EXPECT_THAT(read_file(out / "runs.csv"), HasSubstr("\n1,none,2,failed,killed by signal 11"));
  EXPECT_THAT(read_file(out / "summary.csv"), HasSubstr("\nnone,sim_time_s,1,"));
  EXPECT_THAT(read_file(out / "summary.csv"), HasSubstr("\nfull,sim_time_s,2,"));
  EXPECT_EQ(state_of(out)["state"], "complete");

  Process same{small_sweep(out), folder / "same.log"};
  EXPECT_EQ(same.wait(kPatience), 1) << "a failed run is not done again by itself";
  Process again{small_sweep(out, {"--retry-failed"}), folder / "again.log"};
  EXPECT_EQ(again.wait(kPatience), 0) << again.output();
  EXPECT_EQ(count_in(out, "done"), 4U);
}

TEST(Sweep, ThatIsToldToStopTogetherWithItsRunsTakesNoneAsFailed) {
  const test::ScratchFolder folder;
  const fs::path out = folder / "out";
  std::vector<std::string> words = small_sweep(out);
  *std::find(words.begin(), words.end(), "100") = "100000000";
  Process process{words, folder / "log"};
  ASSERT_TRUE(eventually([&] { return fs::exists(out / "none" / "seed_1" / "metrics.json"); }, kPatience));
  const pid_t runner = runner_of(out / "none" / "seed_1");
  ASSERT_GT(runner, 0);

  kill(runner, SIGTERM);  // as a batch system does, which signals all processes in any order
  process.signal(SIGTERM);

  EXPECT_EQ(process.wait(kPatience), 130);
  EXPECT_EQ(count_in(out, "failed"), 0U) << process.output();
  EXPECT_EQ(count_in(out, "pending"), 4U);
}

TEST(Sweep, TasksDoOneRunEachAndALaterCallCollectsThem) {
  const test::ScratchFolder folder;
  const fs::path whole = folder / "whole";
  const fs::path tasks = folder / "tasks";
  Process all{small_sweep(whole, {"--quiet"}), folder / "whole.log"};
  std::vector<std::unique_ptr<Process>> array;
  for (const std::string index : {"0", "1", "2", "3"}) {
    array.push_back(std::make_unique<Process>(small_sweep(tasks, {"--task-index", index}), folder / index));
  }
  for (const auto& task : array) EXPECT_EQ(task->wait(kPatience), 0) << task->output();
  EXPECT_EQ(all.wait(kPatience), 0);
  EXPECT_EQ(all.output(), "");
  EXPECT_FALSE(fs::exists(tasks / "sweep.json"));
  EXPECT_FALSE(fs::exists(tasks / "runs.csv"));

  Process collect{small_sweep(tasks, {"--summarise"}), folder / "collect.log"};

  EXPECT_EQ(collect.wait(kPatience), 0) << collect.output();
  EXPECT_EQ(read_file(tasks / "summary.csv"), read_file(whole / "summary.csv"));
  EXPECT_EQ(read_file(tasks / "sweep.json"), read_file(whole / "sweep.json"));
}

/// Whether the process runs, that is, exists and is not a zombie.
bool is_at_work(pid_t process) {
  std::ifstream file{"/proc/" + std::to_string(process) + "/stat"};
  std::string number;
  std::string name;
  std::string state;
  file >> number >> name >> state;
  return file && state != "Z";
}

TEST(Sweep, ATaskThatIsStartedTwiceRunsOnce) {
  const test::ScratchFolder folder;
  const fs::path out = folder / "out";
  std::vector<std::string> words = small_sweep(out, {"--task-index", "0"});
  *std::find(words.begin(), words.end(), "100") = "100000000";
  Process first{words, folder / "first.log"};
  ASSERT_TRUE(eventually([&] { return fs::exists(out / "none" / "seed_1" / "metrics.json"); }, kPatience));
  const pid_t runner = runner_of(out / "none" / "seed_1");
  ASSERT_GT(runner, 0);

  Process second{words, folder / "second.log"};
  EXPECT_EQ(second.wait(kPatience), 2);
  EXPECT_THAT(second.output(), HasSubstr("another start of task 0 is using it"));
  EXPECT_EQ(runner_of(out / "none" / "seed_1"), runner) << "the first one is left alone";

  first.signal(SIGKILL);
  ASSERT_EQ(first.wait(kPatience), 128 + SIGKILL);
  Process third{words, folder / "third.log"};
  const auto runs_anew = [&] {
    const pid_t now = runner_of(out / "none" / "seed_1");
    return now > 0 && now != runner;
  };
  EXPECT_TRUE(eventually(runs_anew, kPatience)) << third.output();
  EXPECT_FALSE(is_at_work(runner)) << "never two at a time";
}

TEST(Sweep, AFolderInPlaceOfAFileAndTheOtherWayRoundAreToldInOneLine) {
  const test::ScratchFolder folder;
  const auto refusal = [&folder](const fs::path& out) {
    Process process{small_sweep(out), folder / "refused.log"};
    EXPECT_EQ(process.wait(kPatience), 2);
    std::string said = process.output();
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    return said;
  };
  Process process{small_sweep(folder / "run"), folder / "sweep.log"};
  ASSERT_EQ(process.wait(kPatience), 0) << process.output();
  fs::copy(folder / "run", folder / "metrics", fs::copy_options::recursive);

  fs::remove(folder / "metrics/none/seed_1/metrics.json");
  fs::create_directories(folder / "metrics/none/seed_1/metrics.json");
  EXPECT_THAT(refusal(folder / "metrics"), HasSubstr("seed_1/metrics.json: is a folder, not a file"));
  fs::remove_all(folder / "run/none/seed_1");
  test::write_file(folder / "run/none/seed_1", "notes of mine");
  EXPECT_THAT(refusal(folder / "run"), HasSubstr("seed_1: is a file where the folder of a run belongs"));
  EXPECT_EQ(read_file(folder / "run/none/seed_1"), "notes of mine");
  fs::create_directories(folder / "scenario/scenario.toml");
  EXPECT_THAT(refusal(folder / "scenario"), HasSubstr("scenario.toml: is a folder, not a file"));
}

/// Two runs of a controller from outside, a copy of one of the examples.
class SweepOfAController : public testing::Test {
 protected:
  SweepOfAController() { fs::copy_file(kBraitenberg, controller_); }
  /// Nothing in the library changes but the file. A new file: a run may have the old one open.
  void change() const {
    const std::string bytes = read_file(controller_);
    fs::remove(controller_);
    test::write_file(controller_, bytes + " ");
  }
  [[nodiscard]] std::vector<std::string> words(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"caravan",
                                      "sweep",
                                      test::scenario("small.toml"),
                                      "--items",
                                      "0",
                                      "--max-time",
                                      "2",
                                      "--jobs",
                                      "1",
                                      "--out",
                                      folder_ / "out",
                                      "--controller",
                                      controller_};
    if (std::ranges::find(more, "--seeds") == more.end()) words.insert(words.end(), {"--seeds", "1-2"});
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  void expect_refused(const std::vector<std::string>& more) const {
    Process process{words(more), folder_ / "refused.log"};
    EXPECT_EQ(process.wait(kPatience), 2);
    std::string said = process.output();
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_THAT(said, HasSubstr("/out: holds a sweep with another controller: " + controller_.string() +
                                " was changed since (SHA-256 "));
    EXPECT_THAT(said, HasSubstr("choose another --out, or put the former file back"));
  }

  const fs::path kBraitenberg = fs::path{CARAVAN_BIN_DIR}.parent_path() / "controllers/braitenberg.so";
  const test::ScratchFolder folder_;
  const fs::path controller_ = folder_ / "mine.so";
};

TEST_F(SweepOfAController, IsNotContinuedWithAnotherOne) {
  Process first{words(), folder_ / "first.log"};
  ASSERT_EQ(first.wait(kPatience), 0) << first.output();
  const auto controllers = state_of(folder_ / "out")["controllers"];
  ASSERT_EQ(controllers.size(), 1U);
  EXPECT_EQ(controllers[0]["file"], controller_.string());
  EXPECT_EQ(controllers[0]["sha256"].get<std::string>().size(), 64U);

  Process same{words(), folder_ / "same.log"};
  EXPECT_EQ(same.wait(kPatience), 0) << same.output();
  change();
  expect_refused({});
  expect_refused({"--seeds", "1-3"});
  expect_refused({"--summarise"});
}

TEST_F(SweepOfAController, TakesNoTaskOfAnotherOne) {
  Process first{words({"--task-index", "0"}), folder_ / "first.log"};
  ASSERT_EQ(first.wait(kPatience), 0) << first.output();
  change();
  expect_refused({"--task-index", "1"});
}

TEST(Sweep, RefusesWhatItCannotGoOnWithInOneLine) {
  const test::ScratchFolder folder;
  const fs::path out = folder / "out";
  Process first{small_sweep(out, {"--task-index", "0"}), folder / "first.log"};
  ASSERT_EQ(first.wait(kPatience), 0) << first.output();
  const auto refusal = [&folder](std::vector<std::string> words) {
    Process process{std::move(words), folder / "refused.log"};
    EXPECT_EQ(process.wait(kPatience), 2);
    std::string said = process.output();
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    return said;
  };

  std::vector<std::string> other = small_sweep(out);
  *std::find(other.begin(), other.end(), "100") = "101";
  EXPECT_THAT(refusal(other), HasSubstr("other options"));
  EXPECT_THAT(refusal(small_sweep(out, {"--task-index", "4"})), HasSubstr("4 runs, counted from 0"));
  EXPECT_THAT(refusal(small_sweep(out / "scenario.toml")), HasSubstr("cannot be created"));
  EXPECT_THAT(refusal({"caravan", "sweep", "nowhere.toml", "--out", folder / "new"}),
              HasSubstr("nowhere.toml"));
  EXPECT_FALSE(fs::exists(folder / "new"));
}

}  // namespace
}  // namespace caravan
