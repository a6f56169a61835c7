// SPDX-License-Identifier: Apache-2.0
#include "radio_emulator/medium/medium.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "tests/unit/medium/frames_of.hpp"

namespace caravan::radio {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Bytes = std::vector<std::uint8_t>;

Transmission says(std::uint32_t robot, Bytes bytes, std::uint32_t channel = 0) {
  return {.robot = robot, .tuned = channel, .frames = {{channel, std::move(bytes)}}};
}
Transmission listens(std::uint32_t robot, std::uint32_t tuned = 0) {
  return {.robot = robot, .tuned = tuned, .frames = {}};
}

/// A medium and its counters.
struct MediumTest : testing::Test {
  MediumConfig config;
  Drops drops;
  std::uint64_t step = 7;

  std::vector<Reception> deliver_to(const std::vector<Station>& stations,
                                    const std::vector<Transmission>& transmissions) {
    return deliver(config, step, stations, transmissions, drops);
  }
  static std::vector<std::uint32_t> receivers(const std::vector<Reception>& receptions) {
    std::vector<std::uint32_t> robots;
    for (const Reception& reception : receptions) robots.push_back(reception.robot);
    return robots;
  }
};

TEST_F(MediumTest, ReachesARobotAtExactlyTheRangeAndNoneBeyond) {
  const auto heard = deliver_to({{1, 0.0, 0.0}, {2, 2.0, 0.0}, {3, 0.0, 2.001}, {4, 0.0, -2.0}},
                                {says(1, {42}), listens(2), listens(3), listens(4)});
  EXPECT_THAT(receivers(heard), ElementsAre(2, 4));
  EXPECT_THAT(frames_of(heard[0]), ElementsAre(Frame{0, {42}}));
}

TEST_F(MediumTest, NobodyHearsItself) {
  EXPECT_THAT(deliver_to({{1, 0.0, 0.0}}, {says(1, {42})}), IsEmpty());
}

TEST_F(MediumTest, AFrameReachesThoseTunedToItsChannelAtTheMomentOfSending) {
  Transmission sender = says(1, {42}, 9);
  sender.tuned = 0;
  const auto heard =
      deliver_to({{1, 0.0, 0.0}, {2, 1.0, 0.0}, {3, 1.0, 0.0}}, {sender, listens(2, 9), listens(3, 0)});
  EXPECT_THAT(receivers(heard), ElementsAre(2));
}

TEST_F(MediumTest, SeveralChannelsInOneStepGoToTheirOwnListeners) {
  const Transmission sender{1, 0, {{0, {1}}, {5, {2}}, {0, {3}}}};
  const auto heard =
      deliver_to({{1, 0.0, 0.0}, {2, 1.0, 0.0}, {3, 1.0, 0.0}}, {sender, listens(2, 5), listens(3, 0)});
  ASSERT_THAT(receivers(heard), ElementsAre(2, 3));
  EXPECT_THAT(frames_of(heard[0]), ElementsAre(Frame{5, {2}}));
  EXPECT_THAT(frames_of(heard[1]), ElementsAre(Frame{0, {1}}, Frame{0, {3}}));
}

TEST_F(MediumTest, AQueueIsSortedBySenderThenByTheOrderOfSending) {
  const Transmission three{3, 0, {{0, {31}}, {0, {32}}}};
  const auto heard =
      deliver_to({{9, 0.0, 0.0}, {3, 1.0, 0.0}, {1, -1.0, 0.0}}, {three, listens(9), says(1, {11})});
  ASSERT_EQ(receivers(heard).back(), 9U);
  EXPECT_THAT(frames_of(heard.back()), ElementsAre(Frame{0, {11}}, Frame{0, {31}}, Frame{0, {32}}));
}

TEST_F(MediumTest, ResultsAreSortedByReceiverWhateverTheOrderOfTheArguments) {
  const std::vector<Station> stations{{4, 0.0, 0.0}, {2, 0.5, 0.0}, {3, -0.5, 0.0}};
  const std::vector<Station> reversed{stations.rbegin(), stations.rend()};
  EXPECT_THAT(receivers(deliver_to(stations, {says(3, {3}), says(4, {4}), says(2, {2})})),
              ElementsAre(2, 3, 4));
  EXPECT_THAT(receivers(deliver_to(reversed, {says(4, {4}), says(2, {2}), says(3, {3})})),
              ElementsAre(2, 3, 4));
}

TEST_F(MediumTest, AFullQueueDropsTheNewestAndCountsThem) {
  config.queue_length = 2;
  const Transmission three{3, 0, {{0, {31}}, {0, {32}}}};
  const auto heard =
      deliver_to({{9, 0.0, 0.0}, {3, 1.9, 0.0}, {1, -1.9, 0.0}}, {three, listens(9), says(1, {11})});
  ASSERT_THAT(receivers(heard), ElementsAre(9));
  EXPECT_THAT(frames_of(heard[0]), ElementsAre(Frame{0, {11}}, Frame{0, {31}}));
  EXPECT_EQ(drops.queue_full, 1U);
}

TEST_F(MediumTest, AFrameOfExactlyTheMtuPassesALongerOneIsRefusedAndCountedOnce) {
  config.mtu_bytes = 40;
  const auto heard =
      deliver_to({{1, 0.0, 0.0}, {2, 1.0, 0.0}, {3, 1.0, 1.0}},
                 {Transmission{1, 0, {{0, Bytes(40, 7)}, {0, Bytes(41, 7)}}}, listens(2), listens(3)});
  ASSERT_THAT(receivers(heard), ElementsAre(2, 3));
  EXPECT_THAT(frames_of(heard[0]), ElementsAre(Frame{0, Bytes(40, 7)}));
  EXPECT_EQ(drops.over_mtu, 1U);
}

TEST_F(MediumTest, AChannelThatDoesNotExistIsRefusedAndCountedEvenWhenNobodyIsNear) {
  config.channel_count = 16;
  const auto heard = deliver_to({{1, 0.0, 0.0}, {2, 1.0, 0.0}}, {says(1, {42}, 16), listens(2, 16)});
  EXPECT_THAT(heard, IsEmpty());
  EXPECT_EQ(drops.bad_channel, 1U);
  (void)deliver_to({{1, 0.0, 0.0}}, {says(1, {42}, 16)});
  EXPECT_EQ(drops.bad_channel, 2U);
}

TEST_F(MediumTest, ATransmissionOfARobotThatIsNoMemberIsIgnored) {
  EXPECT_THAT(deliver_to({{2, 1.0, 0.0}}, {says(1, {42}), listens(2)}), IsEmpty());
}

TEST_F(MediumTest, AStationWithoutATransmissionHearsNothing) {
  EXPECT_THAT(deliver_to({{1, 0.0, 0.0}, {2, 1.0, 0.0}}, {says(1, {42})}), IsEmpty());
}

TEST_F(MediumTest, OfSeveralTransmissionsOrStationsOfOneRobotTheFirstCounts) {
  const auto heard =
      deliver_to({{1, 0.0, 0.0}, {2, 1.0, 0.0}, {2, 50.0, 0.0}}, {says(1, {1}), says(1, {2}), listens(2)});
  ASSERT_THAT(receivers(heard), ElementsAre(2));
  EXPECT_THAT(frames_of(heard[0]), ElementsAre(Frame{0, {1}}));
}

TEST_F(MediumTest, AStationWithoutAPlaceIsInNobodysRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const auto heard =
      deliver_to({{1, nan, 0.0}, {2, 0.0, 0.0}, {3, inf, 0.0}, {4, 1.0, 0.0}, {5, 0.0, nan}, {6, inf, 0.0}},
                 {says(1, {1}), says(2, {2}), says(3, {3}), says(4, {4}), says(5, {5}), says(6, {6})});
  ASSERT_THAT(receivers(heard), ElementsAre(2, 4));
  EXPECT_THAT(frames_of(heard[0]), ElementsAre(Frame{0, {4}}));
}

TEST_F(MediumTest, LossIsNearItsProbabilityAndCounted) {
  config.propagation.loss_probability = 0.3;
  std::size_t arrived = 0;
  for (step = 0; step < 10000; ++step) {
    arrived += deliver_to({{1, 0.0, 0.0}, {2, 1.0, 0.0}}, {says(1, {1}), listens(2)}).size();
  }
  EXPECT_NEAR(static_cast<double>(arrived), 7000.0, 200.0);
  EXPECT_EQ(arrived + drops.lost, 10000U);
}

TEST_F(MediumTest, AFrameMoreOrLessChangesTheLossOfNoOther) {
  config.propagation.loss_probability = 0.5;
  for (step = 0; step < 200; ++step) {
    const auto alone = deliver_to({{1, 0.0, 0.0}, {2, 1.0, 0.0}}, {says(1, {1}), listens(2)});
    const auto crowd = deliver_to({{1, 0.0, 0.0}, {2, 1.0, 0.0}, {3, 1.0, 1.0}},
                                  {Transmission{1, 0, {{0, {1}}, {0, {9}}}}, listens(2), says(3, {3})});
    const auto two_hears_it = [](const std::vector<Reception>& heard) {
      return std::any_of(heard.begin(), heard.end(), [](const Reception& reception) {
        return reception.robot == 2 && reception.frames[0].bytes == Bytes{1};
      });
    };
    EXPECT_EQ(two_hears_it(alone), two_hears_it(crowd)) << "step " << step;
  }
}

TEST_F(MediumTest, CertainLossLosesEverything) {
  config.propagation.loss_probability = 1.0;
  for (step = 0; step < 100; ++step) {
    EXPECT_THAT(deliver_to({{1, 0.0, 0.0}, {2, 1.0, 0.0}}, {says(1, {1}), listens(2)}), IsEmpty());
  }
}

}  // namespace
}  // namespace caravan::radio
