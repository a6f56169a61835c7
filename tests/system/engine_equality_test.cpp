// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "build_paths.hpp"
#include "tests/system/support/process.hpp"

namespace caravan {
namespace {

namespace fs = std::filesystem;
using test::Process;
using test::read_file;

/// Runs the scenario long enough for robots to find the destination, meet and exchange paths.
nlohmann::json run(const fs::path& scenario, const std::string& engine, const std::string& mode, int seed,
                   const fs::path& out, const fs::path& log, const std::vector<std::string>& more = {}) {
  std::vector<std::string> line{
      "caravan", "run", scenario,     "--engine", engine,  "--mode", mode,     "--seed", std::to_string(seed),
      "--items", "0",   "--max-time", "150",      "--out", out,      "--quiet"};
  line.insert(line.end(), more.begin(), more.end());
  Process process{line, log};
  EXPECT_EQ(process.wait(std::chrono::seconds{60}), 0) << process.output();
  return nlohmann::json::parse(read_file(out / "metrics.json"));
}

/// Everything that must not depend on the engine: all but its name and the wall time.
/// Without what differs between two engines: times, and the command line in the provenance.
nlohmann::json without_wall_time(nlohmann::json metrics) {
  for (const char* key : {"engine", "wall_time_s", "real_time_factor", "time_split", "provenance"})
    metrics.erase(key);
  return metrics;
}

/// The first line in which two texts differ; empty if they are equal. The texts are too long to print.
std::string first_difference(const std::string& one, const std::string& other) {
  std::istringstream ones{one};
  std::istringstream others{other};
  std::string here;
  std::string there;
  for (int line = 1; one != other; ++line) {
    const bool more = static_cast<bool>(std::getline(ones, here));
    const bool others_more = static_cast<bool>(std::getline(others, there));
    if (here != there || more != others_more) {
      return "line " + std::to_string(line) + ": " + here.append(" | ").append(there);
    }
  }
  return "";
}

class EngineEquality : public testing::TestWithParam<std::tuple<std::string, int>> {};

TEST_P(EngineEquality, ProcessesOnDdsAndOneProcessGiveTheSameRunBitForBit) {
  const auto& [mode, seed] = GetParam();
  const test::ScratchFolder folder;
  const fs::path dds = folder / "dds";
  const fs::path embedded = folder / "embedded";

  const fs::path scenario = test::scenario("small.toml");
  const nlohmann::json on_dds = run(scenario, "dds", mode, seed, dds, folder / "dds.log");
  const nlohmann::json in_one = run(scenario, "embedded", mode, seed, embedded, folder / "embedded.log");

  ASSERT_EQ(on_dds["digest"], in_one["digest"]);
  EXPECT_EQ(without_wall_time(on_dds), without_wall_time(in_one));
  for (const char* name :
       {"tracks.csv", "trips.csv", "events.csv", "paths.csv", "activities.csv", "path_lengths.csv"}) {
    EXPECT_EQ(first_difference(read_file(dds / name), read_file(embedded / name)), "") << name;
  }
}

TEST(EngineEqualityOfAController, FromASharedLibraryGivesTheSameRunAndTheSameRecords) {
  const test::ScratchFolder folder;
  const fs::path scenario = test::scenario("small.toml");
  const std::vector<std::string> chatterer{
      "--controller", fs::path{CARAVAN_BIN_DIR}.parent_path() / "tests/controllers/chatterer.so"};

  const nlohmann::json on_dds =
      run(scenario, "dds", "full", 1, folder / "dds", folder / "dds.log", chatterer);
  const nlohmann::json in_one =
      run(scenario, "embedded", "full", 1, folder / "embedded", folder / "embedded.log", chatterer);

  ASSERT_EQ(on_dds["digest"], in_one["digest"]);
  EXPECT_EQ(on_dds["controller"], "chatterer");
  EXPECT_EQ(without_wall_time(on_dds), without_wall_time(in_one));
  for (const char* name : {"tracks.csv", "trips.csv", "events.csv", "activities.csv"})
    EXPECT_EQ(first_difference(read_file(folder / "dds" / name), read_file(folder / "embedded" / name)), "")
        << name;
}

TEST(EngineEqualityOnAPoorRadio, LosesTheSameFrames) {
  const test::ScratchFolder folder;
  const fs::path scenario = folder / "lossy.toml";
  test::write_file(scenario, test::replaced(read_file(test::scenario("small.toml")), "[radio]\n",
                                            "[radio]\nloss_probability = 0.3\n"));

  const nlohmann::json on_dds = run(scenario, "dds", "full", 4, folder / "dds", folder / "dds.log");
  const nlohmann::json in_one =
      run(scenario, "embedded", "full", 4, folder / "embedded", folder / "embedded.log");

  EXPECT_GT(in_one["frames"]["lost"], 0);
  EXPECT_EQ(without_wall_time(on_dds), without_wall_time(in_one));
}

INSTANTIATE_TEST_SUITE_P(ModesAndSeeds, EngineEquality,
                         testing::Values(std::tuple{"full", 1}, std::tuple{"partial", 2},
                                         std::tuple{"none", 3}));

}  // namespace
}  // namespace caravan
