// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/provenance_json.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "experiment/metrics/metrics_json.hpp"
#include "experiment/metrics/recorded_run.hpp"
#include "experiment/metrics/run_directory.hpp"
#include "runtime/config/start_error.hpp"

namespace caravan::experiment {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::HasSubstr;

runtime::Provenance example() {
  return {.build = {.version = "0.1.0",
                    .commit = {.id = "aaaa", .dirty = true},
                    .compiler = "GNU 12.2.0",
                    .type = "Release",
                    .flags = "-O3 -DNDEBUG",
                    .libraries = {{"eigen", "3.4.0"}, {"ode", "0.16.2"}}},
          .host = {.processor = "P",
                   .architecture = "x86_64",
                   .cores = 2,
                   .kernel = "Linux 6.1",
                   .release = "Debian 12"},
          .command_line = {"caravan", "run", "a file.toml"},
          .seeds = {{"controller.seed", 7}, {"seed", 9223372036854775807U}},
          .scenario_sha256 = "cccc",
          .transport = "udp",
          .agents_per_process = 3,
          .controller = runtime::HashedFile{"/mine.so", "dddd"},
          .agent = {}};
}

TEST(ProvenanceJson, HasTheDocumentedKeys) {
  const Json expected = Json::parse(R"({
    "version": "0.1.0", "commit": "aaaa", "dirty": true, "compiler": "GNU 12.2.0", "build_type": "Release",
    "compiler_flags": "-O3 -DNDEBUG", "libraries": {"eigen": "3.4.0", "ode": "0.16.2"},
    "host": {"processor": "P", "architecture": "x86_64", "cores": 2, "kernel": "Linux 6.1",
             "release": "Debian 12"},
    "command_line": ["caravan", "run", "a file.toml"],
    "seeds": {"controller.seed": 7, "seed": 9223372036854775807},
    "scenario": {"file": "scenario.toml", "sha256": "cccc"}, "transport": "udp", "agents_per_process": 3,
    "controller": {"file": "/mine.so", "sha256": "dddd"}, "agent": null})");

  EXPECT_EQ(Json::parse(provenance_json(example()).dump()), expected);
}

TEST(ProvenanceJson, IsReadBackAsItWas) {
  const auto written = provenance_json(example());

  const runtime::Provenance read = read_provenance(Json::parse(written.dump()));

  EXPECT_EQ(provenance_json(read), written);
  runtime::Provenance unknown = example();
  unknown.build.commit = {.id = "unknown", .dirty = std::nullopt};
  const auto of_archive = provenance_json(unknown);
  EXPECT_TRUE(of_archive.at("dirty").is_null());
  EXPECT_EQ(provenance_json(read_provenance(Json::parse(of_archive.dump()))), of_archive);
}

TEST(ProvenanceJson, IsTheLastKeyOfTheMetricsAndChangesNoOther) {
  RunFacts facts{.scenario = "small", .engine = "dds", .mode = "full"};
  auto before = nlohmann::ordered_json::parse(metrics_json(facts, {}, {}));
  facts.provenance = example();

  auto with = nlohmann::ordered_json::parse(metrics_json(facts, {}, {}));

  EXPECT_EQ(std::prev(with.end()).key(), "provenance");
  EXPECT_EQ(with["provenance"], provenance_json(example()));
  with.erase("provenance");
  before.erase("provenance");
  EXPECT_EQ(with, before);
}

TEST(ProvenanceJson, OfARecordComesWithTheScenario) {
  const Json header = Json::parse(record_header(example(), "seed = 9\n"));

  EXPECT_EQ(header.at("provenance").at("commit"), "aaaa");
  EXPECT_EQ(header.at("scenario"), "seed = 9\n");
}

class RecordedRuns : public testing::Test {
 protected:
  RecordedRuns() { fs::create_directories(folder_); }
  ~RecordedRuns() override { fs::remove_all(folder_); }
  void write(const std::string& metrics) const { write_whole_file(folder_ / "metrics.json", metrics); }
  [[nodiscard]] std::string complaint() const {
    try {
      (void)read_recorded_run(folder_);
    } catch (const runtime::StartError& error) {
      return error.what();
    }
    return "";
  }
  [[nodiscard]] static std::string good() {
    RunFacts facts{.scenario = "small", .engine = "dds", .mode = "full"};
    facts.provenance = example();
    RunEnd end;
    end.digest = "0123456789abcdef";
    end.disturbed = true;
    end.failure = "no space";
    return metrics_json(facts, {}, end);
  }

  fs::path folder_ = fs::temp_directory_path() / ("caravan-recorded-" + std::to_string(getpid()));
};

TEST_F(RecordedRuns, AreReadFromTheirFolder) {
  write(good());

  const RecordedRun run = read_recorded_run(folder_);

  EXPECT_EQ(run.engine, "dds");
  EXPECT_EQ(run.digest, "0123456789abcdef");
  EXPECT_TRUE(run.ended);
  EXPECT_TRUE(run.disturbed);
  EXPECT_FALSE(run.interrupted);
  EXPECT_EQ(run.failure, "no space");
  EXPECT_EQ(provenance_json(run.provenance), provenance_json(example()));
}

TEST_F(RecordedRuns, ThatCannotBeReadAreNamedInOneLine) {
  EXPECT_THAT(complaint(), HasSubstr(folder_.string() + ": is not the folder of a run"));
  write(good().substr(0, 100));
  EXPECT_THAT(complaint(), HasSubstr("metrics.json: is damaged: it is not JSON"));
  auto json = Json::parse(good());
  json["provenance"]["seeds"] = "one";
  write(json.dump());
  EXPECT_THAT(complaint(), HasSubstr("metrics.json: is damaged: "));
  EXPECT_EQ(complaint().find('\n'), std::string::npos);
  json.erase("provenance");
  write(json.dump());
  EXPECT_THAT(complaint(), HasSubstr("has no provenance"));
}

}  // namespace
}  // namespace caravan::experiment
