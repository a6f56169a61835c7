// SPDX-License-Identifier: Apache-2.0
#include "tests/system/support/grid.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <algorithm>
#include <csignal>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "runtime/pure/random.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

/// Rows of a table of which no field has a comma.
std::vector<std::vector<std::string>> rows_of(const fs::path& file) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream text{read_file(file)};
  for (std::string line; std::getline(text, line);) {
    rows.emplace_back();
    std::istringstream fields{line + ","};
    for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(field);
  }
  return rows;
}

/// runs.csv without what depends on the machine.
std::vector<std::vector<std::string>> results_of(const fs::path& out) {
  auto rows = rows_of(out / "runs.csv");
  for (const std::string wall : {"wall_time_s", "real_time_factor"}) {
    const auto column = std::find(rows.at(0).begin(), rows.at(0).end(), wall) - rows.at(0).begin();
    for (auto& row : rows) row.erase(row.begin() + column);
  }
  return rows;
}

/// The runs that are done, and the file of each result: another one when the run was done again.
std::map<std::string, std::pair<ino_t, std::time_t>> done_in(const fs::path& out) {
  std::map<std::string, std::pair<ino_t, std::time_t>> done;
  if (!fs::exists(out)) return done;
  for (const auto& entry : fs::recursive_directory_iterator{out}) {
    if (entry.path().filename() != "metrics.json") continue;
    const auto metrics = nlohmann::json::parse(read_file(entry.path()), nullptr, false);
    struct stat status {};
    if (metrics.is_discarded() || !metrics.at("ended").get<bool>() || metrics.at("interrupted").get<bool>())
      continue;
    if (stat(entry.path().c_str(), &status) == 0)
      done[fs::relative(entry.path(), out)] = {status.st_ino, status.st_mtime};
  }
  return done;
}

}  // namespace

void expect_to_survive_kills(const std::vector<std::string>& words, int kills, std::uint64_t seed) {
  const ScratchFolder folder;
  const auto with_out = [&words](const fs::path& out) {
    std::vector<std::string> all = words;
    all.insert(all.end(), {"--out", out});
    return all;
  };
  const auto began = std::chrono::steady_clock::now();
  Process uninterrupted{with_out(folder / "whole"), folder / "whole.log"};
  ASSERT_EQ(uninterrupted.wait(std::chrono::hours{2}), 0) << uninterrupted.output();
  const auto took = std::chrono::duration_cast<milliseconds>(std::chrono::steady_clock::now() - began);

  const fs::path out = folder / "killed";
  pure::Random random{seed};
  std::size_t most = 0;
  for (int i = 0; i < kills; ++i) {
    const auto before = done_in(out);
    Process process{with_out(out), folder / "killed.log"};
    (void)process.runs_on_for(milliseconds{
        static_cast<long>(random.uniform(0.0, 1.6 / kills) * static_cast<double>(took.count()))});
    process.signal(SIGKILL);
    (void)process.wait(kPatience);
    const auto after = done_in(out);
    most = std::max(most, after.size());
    for (const auto& [run, file] : before) {
      const auto found = after.find(run);
      ASSERT_NE(found, after.end()) << run << " is lost";
      EXPECT_EQ(found->second, file) << run << " was done again";
    }
  }
  EXPECT_GT(most, 0U) << "every kill came before the first result";
  const auto before = done_in(out);
  Process rest{with_out(out), folder / "rest.log"};
  ASSERT_EQ(rest.wait(std::chrono::hours{2}), 0) << rest.output();
  const auto after = done_in(out);
  for (const auto& [run, file] : before) EXPECT_EQ(after.at(run), file) << run << " was done again";
  EXPECT_EQ(results_of(out), results_of(folder / "whole"));
  EXPECT_EQ(read_file(out / "summary.csv"), read_file(folder / "whole" / "summary.csv"));
  EXPECT_EQ(read_file(out / "sweep.json"), read_file(folder / "whole" / "sweep.json"));
}

}  // namespace caravan::test
