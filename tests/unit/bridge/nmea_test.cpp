// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hardware_bridge/core/nmea/sentence.hpp"

namespace caravan::bridge::nmea {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> found_in(const std::string& text) {
  SentenceFinder finder;
  return finder.feed({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

// Well-known example sentences that many manuals print.
constexpr const char* kGga = "$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\r\n";
constexpr const char* kRmc = "$GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W*6A\r\n";

TEST(Nmea, ReadsAPosition) {
  const auto sentences = found_in(kGga);
  ASSERT_EQ(sentences.size(), 1U);
  const auto gga = std::get<Gga>(parse(sentences[0]).value());
  EXPECT_DOUBLE_EQ(gga.time_of_day_s, 12 * 3600 + 35 * 60 + 19);
  EXPECT_NEAR(gga.latitude_deg, 48.0 + 7.038 / 60.0, 1e-12);
  EXPECT_NEAR(gga.longitude_deg, 11.0 + 31.0 / 60.0, 1e-12);
  EXPECT_EQ(gga.quality, 1U);
  EXPECT_EQ(gga.satellites, 8U);
  EXPECT_EQ(gga.hdop, 0.9);
}

TEST(Nmea, ReadsSpeedAndCourse) {
  const auto sentences = found_in(kRmc);
  ASSERT_EQ(sentences.size(), 1U);
  const auto rmc = std::get<Rmc>(parse(sentences[0]).value());
  EXPECT_TRUE(rmc.valid);
  EXPECT_NEAR(rmc.speed_mps, 22.4 * 1852.0 / 3600.0, 1e-9);
  EXPECT_DOUBLE_EQ(rmc.course_deg.value(), 84.4);
}

TEST(Nmea, SouthAndWestAreNegativeAndTheTalkerDoesNotMatter) {
  const auto gga = std::get<Gga>(parse("GNGGA,000000,3330.000,S,07030.000,W,4,20,0.5,1,M,1,M,,").value());
  EXPECT_DOUBLE_EQ(gga.latitude_deg, -33.5);
  EXPECT_DOUBLE_EQ(gga.longitude_deg, -70.5);
}

TEST(Nmea, RefusesAWrongChecksumAndFindsWhatFollows) {
  std::string wrong = kGga;
  wrong[8] = '9';
  EXPECT_THAT(found_in(wrong), IsEmpty());
  EXPECT_EQ(found_in("noise $GPGGA,12" + std::string{kRmc}).size(), 1U)
      << "a torn sentence before a whole one";
  EXPECT_EQ(found_in(std::string(1000, 'x') + kRmc).size(), 1U);
  EXPECT_EQ(found_in("$" + std::string(1000, 'x') + "\r\n" + kRmc).size(), 1U);
}

TEST(Nmea, WithoutFixThereIsNoPlace) {
  EXPECT_EQ(std::get<Gga>(parse("GPGGA,123519,,,,,0,00,,,M,,M,,").value()).quality, 0U);
  EXPECT_FALSE(std::get<Rmc>(parse("GPRMC,123519,V,,,,,,,230394,,").value()).valid);
}

TEST(Nmea, RefusesFieldsThatMakeNoSense) {
  for (const char* sentence : {"GPGGA,123519,9907.038,N,01131.000,E,1,08,0.9,1,M,1,M,,",
                               "GPGGA,123519,4807.038,X,01131.000,E,1,08,0.9,1,M,1,M,,",
                               "GPGGA,123519,nan,N,01131.000,E,1,08,0.9,1,M,1,M,,",
                               "GPGGA,123519,4807.038,N,01131.000,E,x,08,0.9,1,M,1,M,,",
                               "GPGGA,123519,4860.000,N,01131.000,E,1,08,0.9,1,M,1,M,,",
                               "GPGGA,123519,4807.038,N,01199.000,E,1,08,0.9,1,M,1,M,,",
                               "GPGGA,123519,4807.038,N,01131.000,E,1.5,08,0.9,1,M,1,M,,",
                               "GPGGA,123519,4807.038,N,01131.000,E,1,-8,0.9,1,M,1,M,,",
                               "GPGGA,123519,4807.038,N,01131.000,E,1,08,-0.9,1,M,1,M,,",
                               "GPGGA,126019,4807.038,N,01131.000,E,1,08,0.9,1,M,1,M,,",
                               "GPGGA,123561,4807.038,N,01131.000,E,1,08,0.9,1,M,1,M,,",
                               "GPGGA,,4807.038,N,01131.000,E,1,08,0.9,1,M,1,M,,", "GPGGA,123519",
                               "GPRMC,123519,A,4807.038,N,01131.000,E,-1,084.4,230394,003.1,W",
                               "GPRMC,123519,A,4807.038,N,01131.000,E,022.4,384.4,230394,003.1,W",
                               "GPRMC,123519,A,4807.038,N,,E,022.4,084.4,230394,003.1,W"}) {
    EXPECT_FALSE(parse(sentence)) << sentence;
  }
  EXPECT_TRUE(std::holds_alternative<Other>(parse("GPGSV,3,1,11").value()));
}

TEST(Nmea, WhatIsWrittenComesBackToATenthOfAMillimetre) {
  Gga gga{45296.78, -48.123456789, 179.99999999, 1, 9, 1.1};
  const auto sentences = found_in(to_line(gga));
  ASSERT_EQ(sentences.size(), 1U);
  const auto again = std::get<Gga>(parse(sentences[0]).value());
  EXPECT_NEAR(again.time_of_day_s, 45296.78, 1e-6);
  EXPECT_NEAR(again.latitude_deg, gga.latitude_deg, 1e-9);
  EXPECT_NEAR(again.longitude_deg, gga.longitude_deg, 1e-9);
  Rmc rmc{10.0, true, 0.0, 0.0, 1.5, 271.5};
  const auto line = found_in(to_line(rmc));
  ASSERT_EQ(line.size(), 1U);
  EXPECT_NEAR(std::get<Rmc>(parse(line[0]).value()).speed_mps, 1.5, 1e-3);
  EXPECT_DOUBLE_EQ(std::get<Rmc>(parse(line[0]).value()).course_deg.value(), 271.5);
}

TEST(Nmea, TwoSentencesInPiecesAreTwoSentences) {
  const std::string text = std::string{kGga} + kRmc;
  SentenceFinder finder;
  std::size_t found = 0;
  for (const char c : text) {
    const auto byte = static_cast<std::uint8_t>(c);
    found += finder.feed({&byte, 1}).size();
  }
  EXPECT_EQ(found, 2U);
}

}  // namespace
}  // namespace caravan::bridge::nmea
