// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hardware_bridge/core/pose/fix_gate.hpp"

namespace caravan::bridge {
namespace {

using Verdict = FixGate::Verdict;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

FixGate trusting_gate() {
  FixGate gate{5.0};
  for (unsigned i = 1; i < FixGate::kAgreeing; ++i) EXPECT_EQ(gate.judge({1.0, 1.0}, {}), Verdict::kDoubted);
  EXPECT_EQ(gate.judge({1.0, 1.0}, {}), Verdict::kTaken);
  return gate;
}

TEST(FixGate, BeginsWithSeveralThatAgree) {
  FixGate gate{5.0};
  EXPECT_EQ(gate.judge({93.0, 0.0}, {}), Verdict::kDoubted);
  for (unsigned i = 1; i < FixGate::kAgreeing; ++i) EXPECT_EQ(gate.judge({30.0, 0.0}, {}), Verdict::kDoubted);
  EXPECT_EQ(gate.judge({31.0, 0.0}, {}), Verdict::kTakenAnew);
  EXPECT_EQ(gate.judge({31.0, 0.0}, {30.0, 0.0}), Verdict::kTaken);
}

TEST(FixGate, TakesWhatIsNearAndRefusesWhatIsFar) {
  FixGate gate = trusting_gate();
  EXPECT_EQ(gate.judge({4.0, 3.0}, {}), Verdict::kTaken);
  EXPECT_EQ(gate.judge({4.0, 3.1}, {}), Verdict::kOutlier);
}

TEST(FixGate, AfterAnOutlierTheOldPlaceNeedsAsManyAsANewOne) {
  FixGate gate = trusting_gate();
  EXPECT_EQ(gate.judge({100.0, 0.0}, {}), Verdict::kOutlier);
  for (unsigned i = 1; i < FixGate::kAgreeing; ++i) EXPECT_EQ(gate.judge({0.0, 0.0}, {}), Verdict::kDoubted);
  EXPECT_EQ(gate.judge({0.0, 0.0}, {}), Verdict::kTaken);
}

TEST(FixGate, FixesThatDoNotAgreeWithOneAnotherAreNeverTaken) {
  FixGate gate = trusting_gate();
  EXPECT_EQ(gate.judge({100.0, 0.0}, {}), Verdict::kOutlier);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(gate.judge({100.0 + 6.0 * i, i % 2 == 0 ? 50.0 : -50.0}, {}), Verdict::kDoubted) << i;
  }
}

TEST(FixGate, OdometryMovesTheRowToo) {
  FixGate gate = trusting_gate();
  EXPECT_EQ(gate.judge({50.0, 0.0}, {}), Verdict::kOutlier);
  for (unsigned i = 2; i < FixGate::kAgreeing; ++i) {
    EXPECT_EQ(gate.judge({50.0 + 4.0 * i, 0.0}, {4.0 * i, 0.0}), Verdict::kDoubted);
  }
  EXPECT_EQ(gate.judge({90.0, 0.0}, {40.0, 0.0}), Verdict::kTakenAnew);
}

TEST(FixGate, SaysWhatIsWrongWithAFix) {
  const auto of = [](unsigned quality, unsigned satellites, std::optional<double> hdop) {
    nmea::Gga gga;
    gga.quality = quality;
    gga.satellites = satellites;
    gga.hdop = hdop;
    return complaint(gga);
  };
  for (const unsigned quality : {1U, 2U, 3U, 4U, 5U}) EXPECT_THAT(of(quality, 8, 0.9), IsEmpty());
  for (const unsigned quality : {0U, 6U, 7U, 8U})
    EXPECT_THAT(of(quality, 8, 0.9), HasSubstr("no fix")) << quality;
  EXPECT_THAT(of(1, 3, 99.9), HasSubstr("too poor"));
  EXPECT_THAT(of(1, 8, 99.9), HasSubstr("too poor"));
  EXPECT_THAT(of(1, 3, 0.9), HasSubstr("too poor"));
  EXPECT_THAT(of(1, 8, std::nullopt), HasSubstr("8 satellites, no HDOP;"));
}

}  // namespace
}  // namespace caravan::bridge
