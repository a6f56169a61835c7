// SPDX-License-Identifier: Apache-2.0
#include "deploy/cli/rerun.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "deploy/cli/run_provenance.hpp"
#include "experiment/metrics/metrics_json.hpp"
#include "experiment/metrics/run_directory.hpp"
#include "runtime/config/start_error.hpp"
#include "runtime/config/toml_table.hpp"
#include "runtime/provenance/collect.hpp"
#include "runtime/provenance/sha256.hpp"

namespace caravan::deploy {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kScenario = "seed = 3\n";

/// Folders of runs, written without running anything.
class Reruns : public testing::Test {
 protected:
  Reruns() {
    fs::create_directories(run_);
    experiment::write_whole_file(run_ / "scenario.toml", kScenario);
    facts_.engine = "dds";
    facts_.provenance.build = runtime::this_build();
    facts_.provenance.host = runtime::this_host();
    facts_.provenance.scenario_sha256 = runtime::sha256(kScenario);
    facts_.provenance.transport = "udp";
    facts_.provenance.agents_per_process = 2;
    end_.digest = "0123456789abcdef";
    record();
  }
  ~Reruns() override { fs::remove_all(folder_); }

  void record(const fs::path& folder) const {
    fs::create_directories(folder);
    experiment::write_whole_file(folder / "metrics.json", experiment::metrics_json(facts_, {}, end_, ended_));
  }
  void record() const { record(run_); }
  [[nodiscard]] Rerun plan(const RerunCommand& more = {}) const {
    RerunCommand command = more;
    command.run = run_;
    return plan_rerun(command);
  }
  [[nodiscard]] std::string complaint(const RerunCommand& more = {}) const {
    try {
      (void)plan(more);
    } catch (const runtime::StartError& error) {
      return error.what();
    }
    return "";
  }
  /// The code and text of the verdict on a repetition that ended with facts_ and end_.
  [[nodiscard]] std::pair<int, std::string> verdict(const Rerun& rerun) const {
    record(*rerun.run.out);
    char* text = nullptr;
    std::size_t size = 0;
    std::FILE* out = open_memstream(&text, &size);
    const int code = judge_rerun(rerun, out);
    std::fclose(out);
    std::string said{text, size};
    std::free(text);  // NOLINT(cppcoreguidelines-no-malloc): as open_memstream() demands
    return {code, said};
  }

  fs::path folder_ = fs::temp_directory_path() / ("caravan-reruns-" + std::to_string(getpid()));
  fs::path run_ = folder_ / "run";
  experiment::RunFacts facts_;
  experiment::RunEnd end_;
  bool ended_ = true;
};

TEST_F(Reruns, RepeatWhatTheFolderSays) {
  const Rerun rerun = plan();

  EXPECT_EQ(rerun.run.scenario, run_ / "scenario.toml");
  EXPECT_FALSE(rerun.run.embedded);
  EXPECT_EQ(rerun.run.transport, runtime::Transport::kUdp);
  EXPECT_EQ(rerun.run.agents_per_process, 2U);
  EXPECT_EQ(rerun.run.agent, "");
  EXPECT_FALSE(rerun.run.trace);
  EXPECT_EQ(rerun.run.overrides.seed, std::nullopt);
  EXPECT_EQ(rerun.recorded.digest, end_.digest);
}

TEST_F(Reruns, UseAnotherEngineOnRequest) {
  RerunCommand command;
  command.engine = "embedded";

  EXPECT_TRUE(plan(command).run.embedded);
  facts_.engine = "embedded";
  record();
  EXPECT_TRUE(plan().run.embedded);
  command.engine = "dds";
  EXPECT_FALSE(plan(command).run.embedded);
}

TEST_F(Reruns, GoIntoANewFolderOfTheRunOrWhereTheyAreSent) {
  EXPECT_EQ(plan().run.out, run_ / "rerun-1");
  fs::create_directory(run_ / "rerun-1");
  EXPECT_EQ(plan().run.out, run_ / "rerun-2");
  RerunCommand command;
  command.out = folder_ / "elsewhere";
  EXPECT_EQ(plan(command).run.out, folder_ / "elsewhere");
}

TEST_F(Reruns, RecordATraceIfTheRunHasOne) {
  fs::create_directory(run_ / "trace");

  EXPECT_TRUE(plan().run.trace);
}

TEST_F(Reruns, RefuseAScenarioThatWasChanged) {
  experiment::write_whole_file(run_ / "scenario.toml", kScenario + "\n");
  EXPECT_THAT(complaint(),
              StartsWith((run_ / "scenario.toml").string() + ": is not the scenario of the run: "));
  EXPECT_THAT(complaint(), HasSubstr(runtime::sha256(kScenario)));
  fs::remove(run_ / "scenario.toml");
  EXPECT_THAT(complaint(), HasSubstr("scenario.toml: is missing"));
}

TEST_F(Reruns, RefuseAControllerOrAnAgentThatWasChangedOrIsMissing) {
  const fs::path file = folder_ / "program";
  experiment::write_whole_file(file, "then");
  facts_.provenance.controller = runtime::hashed(file);
  record();
  EXPECT_EQ(complaint(), "");
  experiment::write_whole_file(file, "now");
  EXPECT_THAT(complaint(), StartsWith(file.string() + ": is not the controller of the run: "));
  facts_.provenance.agent.swap(facts_.provenance.controller);
  record();
  EXPECT_THAT(complaint(), StartsWith(file.string() + ": is not the agent of the run: "));
  fs::remove(file);
  EXPECT_THAT(complaint(), StartsWith(file.string() + ": cannot be read: "));
}

TEST_F(Reruns, RefuseRunsWithoutAResultThatRepeats) {
  const auto only = [&](auto change) {
    const experiment::RunEnd good = end_;
    change();
    record();
    const std::string said = complaint();
    end_ = good;
    ended_ = true;
    return said;
  };
  EXPECT_THAT(only([&] { ended_ = false; }), HasSubstr("did not reach its end"));
  EXPECT_THAT(only([&] { end_.interrupted = true; }), HasSubstr("was interrupted"));
  EXPECT_THAT(only([&] { end_.disturbed = true; }), HasSubstr("was disturbed"));
  EXPECT_THAT(only([&] { end_.failure = "the disk is full"; }), HasSubstr("failed: the disk is full"));
  EXPECT_EQ(only([] {}), "");
}

TEST_F(Reruns, RefuseFreePacingOverDds) {
  const std::string text = "[experiment]\npacing = \"free\"\n";
  experiment::write_whole_file(run_ / "scenario.toml", text);
  facts_.provenance.scenario_sha256 = runtime::sha256(text);
  record();
  EXPECT_THAT(complaint(), HasSubstr("experiment.pacing is free"));
  facts_.engine = "embedded";
  record();
  EXPECT_EQ(complaint(), "");
}

TEST_F(Reruns, RefuseATransportWhoseFileIsMissing) {
  facts_.provenance.transport = "/nowhere/lan.xml";
  record();
  EXPECT_THAT(complaint(), HasSubstr("no such file: /nowhere/lan.xml"));
  RerunCommand command;
  command.engine = "embedded";
  EXPECT_EQ(complaint(command), "");
}

TEST_F(Reruns, ThatGiveTheDigestAreEqual) {
  EXPECT_EQ(verdict(plan()), std::pair(0, std::string{"equal: digest 0123456789abcdef\n"}));
}

TEST_F(Reruns, ThatGiveAnotherDigestDifferAndSayWhatElseDid) {
  const Rerun rerun = plan();
  end_.digest = "fedcba9876543210";
  facts_.engine = "embedded";
  facts_.provenance.build.libraries["ode"] = "9.9.9";
  facts_.provenance.build.commit.id = "new";
  const std::string ode = rerun.recorded.provenance.build.libraries.at("ode");

  const auto [code, said] = verdict(rerun);

  EXPECT_EQ(code, 1);
  EXPECT_THAT(said, StartsWith("differs: digest fedcba9876543210; the run had 0123456789abcdef\n"));
  EXPECT_THAT(said, HasSubstr("\nother engine: embedded; the run had dds\n"));
  EXPECT_THAT(said, HasSubstr("\nother library ode: 9.9.9; the run had " + ode + "\n"));
  EXPECT_THAT(said, HasSubstr("\nother commit: new"));
}

TEST_F(Reruns, ThatFailedOrWereDisturbedAreNotEqual) {
  const Rerun rerun = plan();
  end_.disturbed = true;
  EXPECT_EQ(verdict(rerun), std::pair(1, std::string{"differs: the repetition was disturbed\n"}));
  end_.failure = "the disk is full";
  EXPECT_EQ(verdict(rerun), std::pair(1, std::string{"differs: the repetition failed: the disk is full\n"}));
}

TEST(RunProvenance, NamesEverySeedOfTheScenario) {
  const auto seeds = [](const std::string& text) {
    return seeds_in(runtime::TomlDocument::parse(text, "test"));
  };
  using Seeds = std::map<std::string, std::uint64_t>;
  EXPECT_EQ(seeds(""), (Seeds{{"seed", 1}})) << "the default";
  EXPECT_EQ(seeds("seed = 5\n[controller]\nnoise_seed = 7\nspeed = 2\nseeds = 3\n"),
            (Seeds{{"controller.noise_seed", 7}, {"seed", 5}}));
}

TEST(RunProvenance, HashesTheScenarioTheControllerAndTheAgent) {
  const fs::path file = fs::temp_directory_path() / ("caravan-controller-" + std::to_string(getpid()));
  experiment::write_whole_file(file, "abc");
  const std::string text = "[controller]\nlibrary = \"" + file.string() + "\"\n";
  RunCommand command;
  command.command_line = {"caravan", "run"};
  command.transport = runtime::Transport::kUdp;
  command.agents_per_process = 4;

  const auto made = provenance_of(command, runtime::TomlDocument::parse(text, "test"), text, file);

  EXPECT_EQ(made.scenario_sha256, runtime::sha256(text));
  ASSERT_TRUE(made.controller && made.agent);
  EXPECT_EQ(made.controller->file, file.string());
  EXPECT_EQ(made.controller->sha256, runtime::sha256("abc"));
  EXPECT_EQ(made.agent->sha256, runtime::sha256("abc"));
  EXPECT_EQ(made.command_line, command.command_line);
  EXPECT_EQ(made.transport, "udp");
  EXPECT_EQ(made.agents_per_process, 4U);
  EXPECT_EQ(provenance_of(command, runtime::TomlDocument::parse("", "test"), "", {}).controller,
            std::nullopt);
  fs::remove(file);
}

}  // namespace
}  // namespace caravan::deploy
