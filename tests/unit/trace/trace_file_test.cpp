// SPDX-License-Identifier: Apache-2.0
#include "runtime/trace/trace_file.hpp"

#include <gmock/gmock.h>

#include "experiment/metrics/text_file.hpp"
#include "experiment/trace/steps.hpp"
#include "experiment/trace/trace_reader.hpp"
#include "runtime/config/start_error.hpp"
#include "tests/unit/sweep/folders.hpp"

namespace caravan::experiment {
namespace {

using Bytes = std::vector<std::uint8_t>;
using runtime::kRadioTrace;
using runtime::kWorldTrace;
using runtime::TraceFile;

class TraceFiles : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file() const { return folder_.path() / "world.trace"; }
  /// The whole steps in the file.
  [[nodiscard]] std::vector<Bytes> steps(bool* cut_off = nullptr) const {
    TraceReader reader{file(), kWorldTrace};
    std::vector<Bytes> all;
    for (Bytes step; reader.next(step);) all.push_back(step);
    if (cut_off != nullptr) *cut_off = reader.cut_off();
    return all;
  }

  Folder folder_;
  const std::vector<Bytes> three_ = {{1, 2, 3}, {}, Bytes(300, 7)};
};

TEST_F(TraceFiles, GiveBackTheirStepsAndTheNumberOfRobots) {
  {
    TraceFile trace{file(), kWorldTrace, 15};
    for (const Bytes& step : three_) trace.record(step);
  }
  EXPECT_EQ(steps(), three_);
  EXPECT_EQ((TraceReader{file(), kWorldTrace}.number()), 15U);
}

TEST_F(TraceFiles, CutOffAnywhereGiveTheWholeStepsBefore) {
  {
    TraceFile trace{file(), kWorldTrace, 2};
    for (const Bytes& step : three_) trace.record(step);
  }
  const std::string whole = *text_in(file());
  const std::size_t begin = whole.find('\n') + 1;
  for (std::size_t length = begin; length < whole.size(); ++length) {
    write(file(), whole.substr(0, length));
    bool cut_off = false;
    const std::vector<Bytes> left = steps(&cut_off);
    const std::size_t expected = length < begin + 7 ? 0 : length < begin + 11 ? 1 : 2;
    ASSERT_EQ(left.size(), expected) << length;
    EXPECT_TRUE(std::equal(left.begin(), left.end(), three_.begin())) << length;
    EXPECT_EQ(cut_off, length != begin && length != begin + 7 && length != begin + 11) << length;
  }
}

TEST_F(TraceFiles, ForgetTheSessionThatIsOver) {
  {
    TraceFile trace{file(), kWorldTrace, 2};
    trace.record(three_[0]);
    trace.restart();
    trace.record(three_[2]);
  }
  EXPECT_THAT(steps(), testing::ElementsAre(three_[2]));
}

TEST_F(TraceFiles, ThatAreMissingForeignOrOfTheOtherPartAreRefused) {
  const auto refused = [this](const std::string& why) {
    EXPECT_THAT(
        [this] {
          (TraceReader{file(), kWorldTrace});
        },
        testing::ThrowsMessage<runtime::StartError>(testing::HasSubstr(why)));
  };
  refused("cannot be read");
  { TraceFile radio{file(), kRadioTrace, 2}; }
  refused("is not a world trace");
  for (const std::string text : {"", "caravan trace 1 world\n", "caravan trace 2 world 4\n",
                                 "\x7f"
                                 "ELF"}) {
    write(file(), text);
    refused("is not a world trace");
  }
  EXPECT_THROW((TraceFile{folder_.path() / "no" / "where", kWorldTrace, 1}), runtime::StartError);
}

TEST(TracedSteps, BeginWithTheRobotsThatWerePutElsewhere) {
  Bytes bytes(2 * (8 + 24 * 2) + 8 + 56 * 2, 0);
  bytes[0] = 2;
  bytes[8 + 24 * 2] = 1;
  bytes[2 * (8 + 24 * 2)] = 77;

  const WorldStep step = read_world_step(bytes, 2);

  ASSERT_EQ(step.placements.size(), 2U);
  EXPECT_EQ(step.placements[0].robot, 2U);
  EXPECT_EQ(step.placements[1].robot, 1U);
  EXPECT_EQ(step.placements[1].poses.size(), 2U);
  EXPECT_EQ(step.number, 77U);
}

TEST(TracedSteps, ThatAreNotWholeOrTooLongAreRefused) {
  const Bytes world(8 + 56 * 2, 0);
  EXPECT_NO_THROW((void)read_world_step(world, 2));
  EXPECT_THROW((void)read_world_step(world, 3), std::runtime_error);
  EXPECT_THROW((void)read_world_step(world, 1), std::runtime_error);
  Bytes radio(24, 0);
  EXPECT_NO_THROW((void)read_radio_step(radio));
  radio[8] = 1;  // announces a transmission that is missing
  EXPECT_THROW((void)read_radio_step(radio), std::runtime_error);
  std::fill(radio.begin(), radio.end(), std::uint8_t{0xff});
  EXPECT_THROW((void)read_radio_step(radio), std::runtime_error);
}

}  // namespace
}  // namespace caravan::experiment
