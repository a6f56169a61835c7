// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "radio_emulator/medium/medium.hpp"
#include "runtime/pure/random.hpp"
#include "tests/unit/medium/frames_of.hpp"

namespace caravan::radio {
namespace {

struct Step {
  MediumConfig config;
  std::vector<Station> stations;
  std::vector<Transmission> transmissions;
};

/// Robots on a coarse grid, so that many pairs are exactly at the range and many share a place.
Step random_step(std::uint64_t seed) {
  pure::Random random{seed};
  Step step;
  step.config.propagation.loss_probability = random.chance(0.5) ? 0.3 : 0.0;
  step.config.queue_length = random.chance(0.5) ? 64 : 5;
  step.config.channel_count = 4;
  step.config.mtu_bytes = 32;
  step.config.seed = seed;
  const auto below = [&random](double limit) {
    return static_cast<std::uint32_t>(random.uniform(0.0, limit));
  };
  const std::uint32_t robots = 1 + below(60.0);
  const double side = random.uniform(2.0, 20.0);
  for (std::uint32_t count = 0; count < robots; ++count) {
    const std::uint32_t robot = 1 + below(80.0);  // sometimes one robot twice
    const bool exact = random.chance(0.5);
    const double x = random.uniform(-side, side);
    const double y = random.uniform(-side, side);
    step.stations.push_back({robot, exact ? std::round(x) : x, exact ? std::round(y) : y});
    if (random.chance(0.1)) continue;
    Transmission transmission{random.chance(0.95) ? robot : 1 + below(80.0), below(5.0), {}};
    for (std::uint32_t frames = below(4.0); frames > 0; --frames) {
      transmission.frames.push_back({below(5.0), std::vector<std::uint8_t>(below(40.0), 1)});
    }
    step.transmissions.push_back(transmission);
  }
  return step;
}

/// A direct implementation of the rules: every receiver, every sender, every frame.
std::vector<Reception> brute_force(const Step& step, std::uint64_t number, Drops& drops) {
  const auto place = [&step](std::uint32_t robot) {
    return std::find_if(step.stations.begin(), step.stations.end(),
                        [robot](const Station& station) { return station.robot == robot; });
  };
  const auto radio = [&step](std::uint32_t robot) {
    return std::find_if(step.transmissions.begin(), step.transmissions.end(),
                        [robot](const Transmission& one) { return one.robot == robot; });
  };
  const auto takes_part = [&](std::uint32_t robot) {
    return place(robot) != step.stations.end() && radio(robot) != step.transmissions.end();
  };
  std::vector<Reception> receptions;
  for (std::uint32_t receiver = 1; receiver <= 80; ++receiver) {
    if (!takes_part(receiver)) continue;
    Reception reception{receiver, {}};
    for (std::uint32_t sender = 1; sender <= 80; ++sender) {
      if (sender == receiver || !takes_part(sender)) continue;
      const double dx = place(sender)->x_m - place(receiver)->x_m;
      const double dy = place(sender)->y_m - place(receiver)->y_m;
      if (dx * dx + dy * dy > step.config.propagation.range_m * step.config.propagation.range_m) continue;
      for (std::size_t index = 0; index < radio(sender)->frames.size(); ++index) {
        const Frame& frame = radio(sender)->frames[index];
        if (frame.bytes.size() > step.config.mtu_bytes || frame.channel >= step.config.channel_count)
          continue;
        if (frame.channel != radio(receiver)->tuned) continue;
        const std::uint64_t draw = pure::mix_all(step.config.seed, number, sender, receiver, index);
        if (pure::unit_interval(draw) < step.config.propagation.loss_probability) {
          ++drops.lost;
        } else if (reception.frames.size() == step.config.queue_length) {
          ++drops.queue_full;
        } else {
          reception.frames.push_back({.channel = frame.channel, .bytes = frame.bytes});
        }
      }
    }
    if (!reception.frames.empty()) receptions.push_back(reception);
  }
  return receptions;
}

TEST(MediumProperty, EqualsBruteForceFrameForFrame) {
  std::size_t delivered = 0;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    const Step step = random_step(seed);
    Drops drops;
    Drops expected_drops;
    const auto heard = deliver(step.config, seed, step.stations, step.transmissions, drops);
    const auto expected = brute_force(step, seed, expected_drops);
    ASSERT_EQ(heard.size(), expected.size());
    for (std::size_t index = 0; index < heard.size(); ++index) {
      EXPECT_EQ(heard[index].robot, expected[index].robot);
      EXPECT_EQ(frames_of(heard[index]), frames_of(expected[index]));
      delivered += heard[index].frames.size();
    }
    EXPECT_EQ(drops.lost, expected_drops.lost);
    EXPECT_EQ(drops.queue_full, expected_drops.queue_full);
  }
  EXPECT_GT(delivered, 2000U);
}

TEST(MediumProperty, TheOrderOfTheArgumentsDoesNotMatter) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    Step step = random_step(seed);
    const auto keep_first = [](auto& items) {
      std::stable_sort(items.begin(), items.end(),
                       [](const auto& a, const auto& b) { return a.robot < b.robot; });
      items.erase(std::unique(items.begin(), items.end(),
                              [](const auto& a, const auto& b) { return a.robot == b.robot; }),
                  items.end());
    };
    keep_first(step.stations);
    keep_first(step.transmissions);
    Drops drops;
    const auto heard = deliver(step.config, seed, step.stations, step.transmissions, drops);
    std::reverse(step.stations.begin(), step.stations.end());
    std::reverse(step.transmissions.begin(), step.transmissions.end());
    const auto again = deliver(step.config, seed, step.stations, step.transmissions, drops);
    ASSERT_EQ(heard.size(), again.size());
    for (std::size_t index = 0; index < heard.size(); ++index) {
      EXPECT_EQ(heard[index].robot, again[index].robot);
      EXPECT_EQ(frames_of(heard[index]), frames_of(again[index]));
    }
  }
}

}  // namespace
}  // namespace caravan::radio
