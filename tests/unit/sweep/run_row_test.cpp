// SPDX-License-Identifier: Apache-2.0
#include "experiment/sweep/run_row.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "experiment/sweep/quantities.hpp"
#include "runtime/config/start_error.hpp"
#include "tests/unit/sweep/folders.hpp"

namespace caravan::experiment {
namespace {

const PlannedRun kRun{.mode = "full", .seed = 3, .scenario_text = "seed = 3\n"};

class RunFolder : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file(const std::string& name) const {
    return sweep_.path() / "full" / "seed_3" / name;
  }
  [[nodiscard]] RunRow look() const { return look_at(sweep_.path(), kRun); }

  Folder sweep_;
};

TEST_F(RunFolder, ThatIsNotThereIsYetToBeRun) { EXPECT_EQ(look().state, RunState::kPending); }

TEST_F(RunFolder, WithCompleteMetricsIsDoneAndGivesEveryQuantity) {
  write(file("scenario.toml"), kRun.scenario_text);
  write(file("metrics.json"), metrics_text(90.0));

  const RunRow row = look();

  EXPECT_EQ(row.state, RunState::kDone);
  EXPECT_EQ(row.digest, "0123456789abcdef");
  ASSERT_EQ(row.values.size(), quantities().size());
  const auto value = [&row](const std::string& name) {
    for (std::size_t i = 0; i < quantities().size(); ++i) {
      if (quantities()[i].column == name) return row.values[i].value_or(-1.0);
    }
    return -2.0;
  };
  EXPECT_EQ(value("completed"), 1.0);
  EXPECT_EQ(value("sim_time_s"), 90.0);
  EXPECT_EQ(value("found"), 1.0);
  EXPECT_EQ(value("received"), 0.0);
  EXPECT_EQ(value("without_path"), 1.0);
  EXPECT_EQ(value("path_length_mean_m"), 10.0);
}

TEST_F(RunFolder, WhoseRunWasKilledOrInterruptedIsToBeRunAgain) {
  write(file("metrics.json"), metrics_text(90.0, false));
  EXPECT_EQ(look().state, RunState::kPending);

  RunEnd interrupted;
  interrupted.interrupted = true;
  write(file("metrics.json"), metrics_text(90.0, true, interrupted));
  EXPECT_EQ(look().state, RunState::kPending);
}

TEST_F(RunFolder, WithHalfAMetricsFileIsToBeRunAgain) {
  const std::string whole = metrics_text(90.0);
  for (std::size_t length = 0; length + 2 < whole.size(); length += 7) {
    write(file("metrics.json"), whole.substr(0, length));
    EXPECT_EQ(look().state, RunState::kPending) << length;
  }
}

TEST_F(RunFolder, WhoseMetricsAreNotWhatARunWritesHasFailedAndSaysWhy) {
  using Json = nlohmann::json;
  const Json right = Json::parse(metrics_text(90.0));
  const auto reason_of = [this](const Json& metrics) {
    write(file("metrics.json"), metrics.dump());
    const RunRow row = look();
    EXPECT_EQ(row.state, RunState::kFailed) << metrics;
    return row.reason;
  };
  for (const char* key : {"per_robot", "robots", "exchanges", "contacts", "sim_time_s", "round_trip_mean_s",
                          "completed", "ended", "failure", "digest"}) {
    for (const Json& value : {Json(nullptr), Json::array({1}), Json::object()}) {
      Json wrong = right;
      wrong[key] = value;
      EXPECT_THAT(reason_of(wrong), testing::HasSubstr("metrics.json is not the output of a run")) << key;
    }
    Json without = right;
    without.erase(key);
    EXPECT_THAT(reason_of(without), testing::HasSubstr(key));
  }
  for (const char* key : {"found_s", "received_s", "path_length_m", "stuck_s", "longest_stuck_s"}) {
    Json wrong = right;
    wrong["per_robot"][1][key] = "long";
    EXPECT_THAT(reason_of(wrong), testing::HasSubstr(key));
  }
  Json fewer = right;
  fewer["per_robot"].erase(1);
  EXPECT_THAT(reason_of(fewer), testing::HasSubstr("per_robot"));
}

TEST_F(RunFolder, ThatIsAFileOrHasAFolderForAFileIsRefused) {
  const auto refused = [this](const std::string& what) {
    EXPECT_THAT([this] { (void)look(); },
                testing::ThrowsMessage<runtime::StartError>(testing::HasSubstr(what)));
  };
  std::filesystem::create_directories(file("metrics.json"));
  refused("metrics.json: is a folder");
  std::filesystem::remove_all(file("").parent_path());
  write(sweep_.path() / "full" / "seed_3", "notes of mine");
  refused("seed_3: is a file");
}

TEST_F(RunFolder, WithANotedFailureHasFailedWhateverElseItHolds) {
  write(file("metrics.json"), metrics_text(90.0, false));
  note_failure(sweep_.path(), kRun, "killed by signal 11");

  EXPECT_EQ(look().state, RunState::kFailed);
  EXPECT_EQ(look().reason, "killed by signal 11");
}

TEST_F(RunFolder, WhoseMetricsTellOfAFailureHasFailed) {
  RunEnd end;
  end.failure = "world_server ended";
  write(file("metrics.json"), metrics_text(90.0, true, end));

  EXPECT_EQ(look().state, RunState::kFailed);
  EXPECT_EQ(look().reason, "world_server ended");
}

TEST_F(RunFolder, OfAnotherScenarioIsRefused) {
  write(file("scenario.toml"), "seed = 4\n");
  EXPECT_THAT([this] { (void)look(); },
              testing::ThrowsMessage<runtime::StartError>(testing::HasSubstr("another scenario")));
}

}  // namespace
}  // namespace caravan::experiment
