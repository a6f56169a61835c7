// SPDX-License-Identifier: Apache-2.0
// The agents' protocol over radios with the limits of real ones: small frames, one channel at a time, no
// reception while sending.
#include <gtest/gtest.h>

#include <array>
#include <iostream>
#include <optional>

#include "hardware_bridge/core/modem/half_duplex.hpp"
#include "robot_agent/core/radio/communication.hpp"
#include "runtime/pure/random.hpp"

namespace caravan {
namespace {

using agent::Time;
using bridge::modem::HalfDuplex;
using namespace std::chrono_literals;

struct Radio {
  std::string name;
  bridge::modem::RadioLimits limits;
};

/// Two robots side by side. Their agents step ten times a second, not at the same times.
class Pair {
 public:
  Pair(const Radio& radio, std::uint64_t seed) : radios_{HalfDuplex{radio.limits}, HalfDuplex{radio.limits}} {
    pure::Random random{seed};
    for (std::size_t i = 0; i < 2; ++i) {
      agent::CommunicationSettings config;
      config.id = agent::RobotId{static_cast<std::uint16_t>(i + 1)};
      config.sharing.starts = Time{0};
      config.air.mtu_bytes = radio.limits.mtu_bytes;
      config.air.channel_count = radio.limits.channel_count;
      robots_[i].emplace(config);
      due_[i] = Time{static_cast<Time::rep>(random.unit() * 1e8)};
    }
    for (int i = 0; i < 120; ++i) path_.emplace_back(0.5 * i, (i % 7) * 0.1);
  }
  /// @return the time at which robot 2 has robot 1's whole path; none: not within `seconds`
  [[nodiscard]] std::optional<double> exchange_within(double seconds) {
    for (Time now{0}; now < bridge::to_time(seconds); now += 100us) {
      carry(now);
      for (std::size_t i = 0; i < 2; ++i) {
        if (now >= due_[i] && step(i, now)) return bridge::seconds(now);
      }
    }
    return std::nullopt;
  }

 private:
  void carry(Time now) {
    for (std::size_t i = 0; i < 2; ++i) {
      while (auto frame = radios_[i].next(now)) {
        if (!radios_[1 - i].hears(frame->channel, now)) continue;
        heard_[1 - i].push_back(
            {.channel = agent::Channel{frame->channel}, .bytes = std::move(frame->bytes)});
      }
    }
  }
  bool step(std::size_t i, Time now) {
    due_[i] += 100ms;
    const std::vector<agent::ReceivedFrame> heard = std::exchange(heard_[i], {});
    const agent::Path& own = i == 0 ? path_ : none_;
    agent::AirOutputs out = robots_[i]->step({now, heard, own});
    for (agent::Frame& frame : out.frames)
      radios_[i].send({frame.channel.value, std::move(frame.bytes)}, now);
    radios_[i].tune(out.tuned.value, now);
    EXPECT_EQ(radios_[i].over_mtu(), 0U);
    return i == 1 && out.received && out.received->size() == path_.size();
  }

  std::array<HalfDuplex, 2> radios_;
  std::array<std::optional<agent::Communication>, 2> robots_;
  std::array<Time, 2> due_{};
  std::array<std::vector<agent::ReceivedFrame>, 2> heard_;
  agent::Path path_;
  agent::Path none_;
};

class RadioModem : public ::testing::TestWithParam<Radio> {};

TEST_P(RadioModem, AWholePathComesAcross) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    SCOPED_TRACE(seed);
    const auto took = Pair{GetParam(), seed}.exchange_within(120.0);
    EXPECT_TRUE(took);
    std::cout << GetParam().name << " seed " << seed << ": " << took.value_or(-1.0) << " s\n";
  }
}

std::string name_of(const ::testing::TestParamInfo<Radio>& radio) { return radio.param.name; }

INSTANTIATE_TEST_SUITE_P(Radios, RadioModem,
                         ::testing::Values(Radio{"Nrf24WithMtu32", {.mtu_bytes = 32, .channel_count = 126}},
                                           Radio{"EspNowWithMtu250",
                                                 {.mtu_bytes = 250,
                                                  .channel_count = 14,
                                                  .bit_rate_bps = 1e6,
                                                  .channel_change = 1ms}}),
                         name_of);

}  // namespace
}  // namespace caravan
