// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "experiment/metrics/csv_file.hpp"
#include "experiment/metrics/record_files.hpp"
#include "experiment/metrics/run_directory.hpp"
#include "experiment/metrics/run_record.hpp"
#include "runtime/config/start_error.hpp"
#include "runtime/config/write_error.hpp"
#include "tests/unit/experiment/observations.hpp"

namespace caravan::experiment {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;
using std::chrono::seconds;
using test::at;
using test::doing;
using test::kStep;
using test::with;

class Outputs : public testing::Test {
 protected:
  Outputs() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() /
              ("caravan_outputs_" + std::string{info->name()} + "_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~Outputs() override { fs::remove_all(folder_); }

  [[nodiscard]] std::vector<std::string> lines_of(const std::string& name) const {
    std::ifstream in{folder_ / name};
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
  }

  fs::path folder_;
};

TEST_F(Outputs, TracksHaveOneRowForEachRobotAndSimulatedSecond) {
  RecordFiles files{folder_, 2};
  for (int i = 0; i * kStep <= seconds{3}; ++i) {
    files.observe(at(i * kStep, {{0.25 * i, 0.0}, {1.0, 2.0}}));
  }
  files.finish();
  files.flush();

  EXPECT_THAT(
      lines_of("tracks.csv"),
      testing::ElementsAre("time_s,robot,x_m,y_m,yaw_rad,mode", "0.000,1,0.0000,0.0000,0.00000,explore",
                           "0.000,2,1.0000,2.0000,0.00000,explore", "1.024,1,8.0000,0.0000,0.00000,explore",
                           "1.024,2,1.0000,2.0000,0.00000,explore", "2.016,1,15.7500,0.0000,0.00000,explore",
                           "2.016,2,1.0000,2.0000,0.00000,explore"));
}

TEST_F(Outputs, TracksSayTransportWithAPathAndExchangeDuringAnExchange) {
  RecordFiles files{folder_, 1};
  AgentReport report = doing(1, Activity::kDriving);
  report.mode = Mode::kTransport;
  files.observe(with(at(seconds{0}, {{0, 0}}), report));
  report.activity = Activity::kExchanging;
  files.observe(with(at(seconds{1}, {{0, 0}}), report));
  files.finish();
  files.flush();

  EXPECT_THAT(lines_of("tracks.csv"), testing::ElementsAre(testing::_, testing::EndsWith(",transport"),
                                                           testing::EndsWith(",exchange")));
}

TEST_F(Outputs, TripsAreWrittenWhenTheNextPickUpEndsThemAndTheRestAtTheEnd) {
  RecordFiles files{folder_, 2};
  const auto item = [&](Time stamp, ItemEvent::Kind kind, std::uint32_t robot) {
    Observation observation = at(stamp, {{0, 0}, {1, 1}});
    observation.item_events = {{.kind = kind, .robot = robot}};
    files.observe(observation);
  };
  item(seconds{10}, ItemEvent::Kind::kPickUp, 2);
  item(seconds{20}, ItemEvent::Kind::kDelivery, 2);
  item(seconds{30}, ItemEvent::Kind::kPickUp, 2);
  files.flush();
  EXPECT_THAT(lines_of("trips.csv"), testing::ElementsAre("robot,trip,picked_up_s,delivered_s,next_pick_up_s",
                                                          "2,1,10.000,20.000,30.000"));
  files.finish();
  files.flush();

  EXPECT_EQ(lines_of("trips.csv").back(), "2,2,30.000,,");
}

TEST_F(Outputs, EventsTellWhatHappenedToWhomAndQuoteCommas) {
  RecordFiles files{folder_, 2};
  Observation first = at(seconds{0}, {{0, 0}, {1, 1}});
  first.contacts = {{.robot = 1, .other = 2}, {.robot = 2, .other = 0}};
  files.observe(first);
  AgentReport report = doing(1, Activity::kDriving);
  report.origin = Origin::kFound;
  report.events = {{.name = "blocked", .detail = "at=\"1,2\""}};
  report.exchanges = {
      {.partner = 2, .session = 9, .completed = true, .began = seconds{1}, .ended = seconds{2}}};
  Observation second = with(at(seconds{2}, {{0, 0}, {1, 1}}), report);
  second.members = {1};
  files.observe(second);
  files.finish();
  files.flush();

  EXPECT_THAT(lines_of("events.csv"),
              testing::ElementsAre("time_s,robot,event,detail", "0.000,1,contact,with=2",
                                   "0.000,2,contact,with=static", "2.000,2,left,",
                                   "2.000,1,exchange,partner=2 session=9 primary=false completed=true "
                                   "began_s=1.000 ended_s=2.000",
                                   "2.000,1,blocked,\"at=\"\"1,2\"\"\""));
}

TEST_F(Outputs, ActivitiesHaveARowForEachChangeOnly) {
  RecordFiles files{folder_, 2};
  files.observe(with(at(seconds{0}, {{0, 0}, {1, 1}}), doing(1, Activity::kDriving)));
  files.observe(with(at(seconds{1}, {{0, 0}, {1, 1}}), doing(1, Activity::kDriving)));
  files.observe(with(at(seconds{2}, {{0, 0}, {1, 1}}), doing(1, Activity::kAvoiding)));
  files.observe(with(at(seconds{3}, {{0, 0}, {1, 1}}), doing(2, Activity::kExchanging)));
  files.observe(with(at(seconds{4}, {{0, 0}, {1, 1}}), doing(2, Activity::kIdle)));
  files.finish();
  files.flush();

  EXPECT_THAT(lines_of("activities.csv"),
              testing::ElementsAre("time_s,robot,activity", "0.000,1,driving", "2.000,1,avoiding",
                                   "3.000,2,exchanging", "4.000,2,idle"));
}

TEST_F(Outputs, PathLengthsHaveARowForEachNewPathInUse) {
  RecordFiles files{folder_, 1};
  AgentReport report = doing(1, Activity::kDriving);
  files.observe(with(at(seconds{0}, {{0, 0}}), report));
  report.path_changed = true;
  report.path = {{0, 0}, {3, 4}, {3, 5}};
  files.observe(with(at(seconds{1}, {{0, 0}}), report));
  report.path_changed = false;
  files.observe(with(at(seconds{2}, {{0, 0}}), report));
  report.path_changed = true;
  report.path = {{0, 0}, {3, 4}};
  files.observe(with(at(seconds{3}, {{0, 0}}), report));
  files.finish();
  files.flush();

  EXPECT_THAT(lines_of("path_lengths.csv"),
              testing::ElementsAre("time_s,robot,length_m", "1.000,1,6.000", "3.000,1,5.000"));
}

TEST_F(Outputs, TheEndOfARunIsNobodysLeaving) {
  RecordFiles files{folder_, 1};
  files.observe(at(seconds{0}, {{0, 0}}));
  Observation end = at(seconds{1}, {{0, 0}});
  end.last = true;
  end.members.clear();
  files.observe(end);
  files.finish();
  files.flush();

  EXPECT_THAT(lines_of("events.csv"), testing::SizeIs(1));
}

TEST_F(Outputs, AFolderThatHoldsSomethingIsRefusedAndAnEmptyOneTaken) {
  EXPECT_EQ(make_run_directory(folder_, {}), folder_);
  std::ofstream{folder_ / "metrics.json"} << "{}";

  EXPECT_THROW((void)make_run_directory(folder_, {}), runtime::StartError);
}

TEST_F(Outputs, TwoRunsInTheSameSecondGetDifferentFolders) {
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  const RunFacts facts{.scenario = "small",
                       .engine = "embedded",
                       .mode = "full",
                       .seed = 3,
                       .robots = 1,
                       .items = 1,
                       .max_time = seconds{1}};

  const fs::path one = make_run_directory(std::nullopt, facts);
  const fs::path other = make_run_directory(std::nullopt, facts);

  EXPECT_NE(one, other);
  EXPECT_TRUE(fs::is_directory(one));
  EXPECT_THAT(one.string(), testing::MatchesRegex("runs/small-full-3-[0-9]{8}-[0-9]{6}"));
  fs::current_path(before);
}

TEST_F(Outputs, ARecordLeavesAllItsFilesAndTheExitCode) {
  const RunFacts facts{.scenario = "small",
                       .engine = "embedded",
                       .mode = "full",
                       .seed = 3,
                       .robots = 1,
                       .items = 1,
                       .max_time = seconds{100}};
  RunRecord record{facts, folder_, nullptr};
  EXPECT_THAT(lines_of("metrics.json"), testing::Contains("  \"ended\": false,")) << "from the beginning";
  EXPECT_THAT(lines_of("tracks.csv"), testing::SizeIs(1));
  AgentReport report = doing(1, Activity::kDriving);
  report.path_changed = true;
  report.path = {{0, 0}, {1.5, 2}};
  record.observe(with(at(seconds{0}, {{0, 0}}), report));
  Observation end = at(seconds{5}, {{0, 0}});
  end.items_delivered = 1;
  record.observe(end);

  EXPECT_EQ(record.close({}), 0);

  for (const char* name : {"metrics.json", "tracks.csv", "trips.csv", "events.csv", "paths.csv",
                           "activities.csv", "path_lengths.csv"}) {
    EXPECT_TRUE(fs::is_regular_file(folder_ / name)) << name;
  }
  EXPECT_THAT(lines_of("paths.csv"),
              testing::ElementsAre("robot,index,x_m,y_m", "1,0,0.0000,0.0000", "1,1,1.5000,2.0000"));
}

/// During its lifetime no file of this process can grow beyond `bytes`; to a writer this looks like a full
/// disk.
class SmallFiles {
 public:
  explicit SmallFiles(rlim_t bytes) : signal_{std::signal(SIGXFSZ, SIG_IGN)} {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SmallFiles() {
    setrlimit(RLIMIT_FSIZE, &before_);
    (void)std::signal(SIGXFSZ, signal_);
  }
  SmallFiles(const SmallFiles&) = delete;
  SmallFiles& operator=(const SmallFiles&) = delete;

 private:
  rlimit before_{};
  void (*signal_)(int);
};

TEST_F(Outputs, WhenThereIsNoRoomForARowAFileEndsWithTheOneBefore) {
  CsvFile file{folder_ / "rows.csv", {"name", "value"}};  // 11 bytes
  {
    const SmallFiles limit{30};
    file.row({"first", "1"});  // 8 bytes
    file.flush();
    file.row({"second", "2"});  // 9 bytes
    file.row({"third", "3"});
    EXPECT_THROW(file.flush(), runtime::WriteError);
  }
  EXPECT_THAT(lines_of("rows.csv"), testing::ElementsAre("name,value", "first,1", "second,2"));

  file.flush();  // there is room again

  EXPECT_THAT(lines_of("rows.csv"), testing::ElementsAre("name,value", "first,1", "second,2", "third,3"));
}

TEST_F(Outputs, ATextThatCannotBeReplacedStays) {
  write_whole_file(folder_ / "metrics.json", "old");
  {
    const SmallFiles limit{10};
    EXPECT_THROW(write_whole_file(folder_ / "metrics.json", "much longer than the old one"),
                 runtime::WriteError);
  }
  EXPECT_THAT(lines_of("metrics.json"), testing::ElementsAre("old"));
  EXPECT_FALSE(fs::exists(folder_ / "metrics.json.new"));
}

TEST_F(Outputs, ARecordThatCannotBeWrittenEndsAndKeepsWhatItHas) {
  const RunFacts facts{.scenario = "small",
                       .engine = "embedded",
                       .mode = "full",
                       .robots = 1,
                       .items = 1,
                       .max_time = seconds{100}};
  RunRecord record{facts, folder_, nullptr};
  for (int second = 0; second < 100; ++second) record.observe(at(seconds{second}, {{0, 0}}));
  Observation end = at(seconds{100}, {{0, 0}});
  end.items_delivered = 1;
  record.observe(end);
  EXPECT_TRUE(record.is_whole());
  const SmallFiles limit{3000};  // enough for metrics.json of one robot, but not for tracks.csv

  EXPECT_EQ(record.close({}), 1) << "though every item was delivered";

  EXPECT_FALSE(record.is_whole());
  std::ifstream metrics{folder_ / "metrics.json"};
  const std::string text{std::istreambuf_iterator<char>{metrics}, {}};
  EXPECT_THAT(text, testing::HasSubstr("tracks.csv: cannot be written: File too large"));
  const auto tracks = lines_of("tracks.csv");
  EXPECT_GT(tracks.size(), 20U);
  EXPECT_THAT(tracks.back(), testing::EndsWith(",explore"));
}

TEST_F(Outputs, AFolderThatCannotBeWrittenIsAnErrorOfTheStart) {
  EXPECT_THROW((RecordFiles{folder_ / "missing", 1}), runtime::StartError);
}

}  // namespace
}  // namespace caravan::experiment
