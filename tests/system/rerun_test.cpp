// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "build_paths.hpp"
#include "tests/system/support/process.hpp"

namespace caravan {
namespace {

namespace fs = std::filesystem;
using test::kPatience;
using test::Process;
using test::read_file;
using testing::HasSubstr;

class Rerun : public testing::Test {
 protected:
  struct Ending {
    std::optional<int> exit_code;
    std::string said;
  };
  [[nodiscard]] Ending ending_of(const std::vector<std::string>& words) const {
    Process process{words, folder_ / "log"};
    const auto code = process.wait(kPatience);
    return {code, process.output()};
  }
  /// A run of the small scenario that lasts some simulated seconds.
  void make_run(const std::string& engine, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"caravan",  "run",        test::scenario("small.toml"),
                                      "--engine", engine,       "--seed",
                                      "4",        "--max-time", "20",
                                      "--items",  "0",          "--out",
                                      run_,       "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    const Ending ending = ending_of(words);
    ASSERT_EQ(ending.exit_code, 0) << ending.said;
  }
  [[nodiscard]] Ending rerun(const std::vector<std::string>& more = {"--quiet"}) const {
    std::vector<std::string> words = {"caravan", "rerun", run_};
    words.insert(words.end(), more.begin(), more.end());
    return ending_of(words);
  }
  [[nodiscard]] nlohmann::json metrics(const fs::path& folder) const {
    return nlohmann::json::parse(read_file(folder / "metrics.json"));
  }
  void change_metrics(const std::function<void(nlohmann::json&)>& change) const {
    nlohmann::json json = metrics(run_);
    change(json);
    test::write_file(run_ / "metrics.json", json.dump());
  }
  /// What `sha256sum` says.
  [[nodiscard]] std::string sha256_of(const fs::path& file) const {
    const std::string command = "sha256sum '" + file.string() + "' > '" + (folder_ / "sum").string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return read_file(folder_ / "sum").substr(0, 64);
  }

  test::ScratchFolder folder_;
  fs::path run_ = folder_ / "run";
};

TEST_F(Rerun, ARunNamesWhatMadeIt) {
  make_run("embedded");

  const auto provenance = metrics(run_).at("provenance");
  EXPECT_THAT(provenance.at("version").get<std::string>(), testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
  EXPECT_THAT(provenance.at("commit").get<std::string>(), testing::MatchesRegex("unknown|[0-9a-f]{40}"));
  EXPECT_EQ(provenance.at("scenario").at("sha256"), sha256_of(run_ / "scenario.toml"));
  EXPECT_EQ(provenance.at("seeds"), (nlohmann::json{{"seed", 4}}));
  const auto words = provenance.at("command_line").get<std::vector<std::string>>();
  ASSERT_EQ(words.size(), 14U);
  EXPECT_EQ(words[1], "run");
  EXPECT_EQ(words[6], "4");
  EXPECT_EQ(provenance.at("controller"), nullptr);
}

TEST_F(Rerun, ATraceNamesWhatMadeItAndHasTheScenario) {
  make_run("embedded", {"--trace"});

  const auto header = nlohmann::json::parse(read_file(run_ / "trace" / "provenance.json"));

  EXPECT_EQ(header.at("provenance"), metrics(run_).at("provenance"));
  EXPECT_EQ(header.at("scenario"), read_file(run_ / "scenario.toml"));
}

TEST_F(Rerun, OfAnUnchangedRunIsEqualAndLiesInItsFolder) {
  make_run("embedded", {"--trace"});
  const std::string before = read_file(run_ / "metrics.json");
  const std::string digest = metrics(run_).at("digest");

  const Ending first = rerun();

  EXPECT_EQ(first.exit_code, 0);
  EXPECT_EQ(first.said, "equal: digest " + digest + "\n");
  EXPECT_EQ(metrics(run_ / "rerun-1").at("digest"), digest);
  EXPECT_EQ(read_file(run_ / "rerun-1" / "trace" / "world.trace"), read_file(run_ / "trace" / "world.trace"));
  EXPECT_EQ(rerun().exit_code, 0);
  EXPECT_TRUE(fs::exists(run_ / "rerun-2" / "metrics.json"));
  EXPECT_EQ(read_file(run_ / "metrics.json"), before);
  EXPECT_EQ(ending_of({"caravan", "rerun", run_ / "rerun-1", "--quiet"}).exit_code, 0) << "of a repetition";
}

TEST_F(Rerun, OfARunOverDdsIsOverDdsOrInOneProcess) {
  make_run("dds", {"--agents-per-process", "2"});

  const Ending same = rerun();
  const Ending other = rerun({"--quiet", "--engine", "embedded", "--out", folder_ / "embedded"});

  EXPECT_EQ(same.exit_code, 0) << same.said;
  EXPECT_EQ(metrics(run_ / "rerun-1").at("engine"), "dds");
  EXPECT_EQ(metrics(run_ / "rerun-1").at("provenance").at("agents_per_process"), 2);
  EXPECT_EQ(other.exit_code, 0) << other.said;
  EXPECT_THAT(other.said, HasSubstr("other engine: embedded; the run had dds\n"));
  EXPECT_EQ(metrics(folder_ / "embedded").at("engine"), "embedded");
}

TEST_F(Rerun, WhoseTimeIsUpBeforeEveryItemIsDeliveredIsEqualToo) {
  EXPECT_EQ(ending_of({"caravan", "run", test::scenario("small.toml"), "--engine", "embedded", "--max-time",
                       "5", "--out", run_, "--quiet"})
                .exit_code,
            1);

  const Ending ending = rerun();

  EXPECT_EQ(ending.exit_code, 0) << ending.said;
}

TEST_F(Rerun, WithAnotherDigestDiffersAndNamesWhatElseIsDifferent) {
  make_run("embedded");
  const std::string digest = metrics(run_).at("digest");
  change_metrics([](nlohmann::json& json) {
    json["digest"] = "0000000000000000";
    json["provenance"]["commit"] = std::string(40, 'a');
    json["provenance"]["libraries"]["ode"] = "0.1.2";
  });

  const Ending ending = rerun();

  EXPECT_EQ(ending.exit_code, 1);
  EXPECT_THAT(ending.said,
              testing::StartsWith("differs: digest " + digest + "; the run had 0000000000000000\n"));
  EXPECT_THAT(ending.said, testing::ContainsRegex("\nother commit: .*; the run had a{40}"));
  EXPECT_THAT(ending.said, testing::ContainsRegex("\nother library ode: .*; the run had 0\\.1\\.2\n"));
}

TEST_F(Rerun, IsRefusedByNameForAFolderThatIsNoRunAndADamagedScenario) {
  const Ending no_run = ending_of({"caravan", "rerun", folder_.path()});
  EXPECT_EQ(no_run.exit_code, 2);
  EXPECT_EQ(no_run.said, folder_.path().string() + ": is not the folder of a run: no metrics.json in it\n");

  make_run("embedded");
  const fs::path scenario = run_ / "scenario.toml";
  test::write_file(scenario, test::replaced(read_file(scenario), "seed = 4", "seed = 5"));
  const Ending damaged = rerun();

  EXPECT_EQ(damaged.exit_code, 2);
  EXPECT_THAT(damaged.said, testing::StartsWith(scenario.string() + ": is not the scenario of the run: "));
  EXPECT_EQ(std::count(damaged.said.begin(), damaged.said.end(), '\n'), 1) << damaged.said;
  EXPECT_FALSE(fs::exists(run_ / "rerun-1"));
}

TEST_F(Rerun, UsesTheControllerOfTheRunAndRefusesAnother) {
  const fs::path controller = folder_ / "mine.so";
  fs::copy_file(fs::path{CARAVAN_BIN_DIR}.parent_path() / "controllers/braitenberg.so", controller);
  make_run("embedded", {"--controller", controller});
  EXPECT_EQ(metrics(run_).at("provenance").at("controller"),
            (nlohmann::json{{"file", controller.string()}, {"sha256", sha256_of(controller)}}));

  const Ending same = rerun();
  std::ofstream{controller, std::ios::app} << "changed";
  const Ending changed = rerun();

  EXPECT_EQ(same.exit_code, 0) << same.said;
  EXPECT_EQ(changed.exit_code, 2);
  EXPECT_THAT(changed.said,
              testing::StartsWith(controller.string() + ": is not the controller of the run: "));
  EXPECT_FALSE(fs::exists(run_ / "rerun-2"));
}

}  // namespace
}  // namespace caravan
