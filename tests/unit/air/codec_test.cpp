// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/radio/frames/codec.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "runtime/pure/overload.hpp"

namespace caravan::agent {
namespace {

using testing::ElementsAre;
using Bytes = std::vector<std::uint8_t>;

constexpr RobotId kThree{3};
constexpr RobotId kSeven{7};

std::optional<Message> message_in(const Bytes& bytes) {
  return std::visit(pure::Overload{[](const auto& message) { return std::optional<Message>{message}; },
                                   [](DecodeError) { return std::optional<Message>{}; }},
                    decode(bytes));
}
DecodeError error_in(const Bytes& bytes) {
  const Decoded decoded = decode(bytes);
  const auto* error = std::get_if<DecodeError>(&decoded);
  if (error == nullptr) throw std::logic_error{"decoded"};
  return *error;
}

/// One message of each type, and messages at the limits of each field.
std::vector<Message> examples() {
  constexpr std::int32_t kLow = std::numeric_limits<std::int32_t>::min();
  constexpr std::int32_t kHigh = std::numeric_limits<std::int32_t>::max();
  return {
      Wait{kThree, Mode::kExplore, Engagement::kFree, {}},
      Wait{RobotId{65535}, Mode::kTransport, Engagement::kFree, {}},
      Wait{kThree, Mode::kExplore, Engagement::kNegotiating, kSeven},
      Wait{kThree, Mode::kTransport, Engagement::kInSession, kSeven},
      Wait{kThree, Mode::kExplore, Engagement::kAway, {}},
      Wait{kThree, Mode::kExplore, Engagement::kFree, {}, Whereabouts{{kLow, kHigh}, 3142, -32768, 32767}},
      Wait{kThree, Mode::kTransport, Engagement::kInSession, kSeven, Whereabouts{{}, -3142, 975, -1}},
      Accept{kSeven, kThree, 1, Mode::kExplore},
      Accept{kSeven, kThree, 65535, Mode::kTransport},
      AcceptAck{kThree, kSeven, 513},
      Reject{kThree, kSeven, 0, Refusal::kBusy},
      Reject{kThree, kSeven, 9, Refusal::kDeclined},
      PathFragment{kSeven, kThree, 9, 0, 0, false, 0, {}},
      PathFragment{kSeven, kThree, 9, 2, 0, true, 65535, {{kLow, kHigh}, {-1, 0}}},
      PathFragment{kSeven, kThree, 9, 65535, 65534, true, 7, {{12345, -54321}}},
      PathFragment{kSeven, kThree, 9, 65535, 65535, true, 7, {}},
      PathFragment{kSeven, kThree, 9, 300, 10, true, 7, std::vector<GridPoint>(255, GridPoint{1, 2})},
      End{kSeven, kThree, 9}};
}

TEST(Codec, WhatIsEncodedDecodesToTheSameMessage) {  // P-10
  for (const Message& message : examples()) EXPECT_EQ(message_in(encode(message)), message);
}

TEST(Codec, LaysAWaitOutAsDocumented) {  // P-11
  EXPECT_THAT(encode(Wait{RobotId{0x0203}, Mode::kTransport, Engagement::kNegotiating, RobotId{0x0405}}),
              ElementsAre(0xC1, 1, 0x03, 0x02, 1, 1, 0x05, 0x04));
}

TEST(Codec, LaysTheWhereaboutsInAWaitOutAsDocumented) {  // P-11
  const Whereabouts place{{0x01020304, -1}, -2, 0x0506, 0x0708};
  EXPECT_THAT(
      encode(Wait{kThree, Mode::kExplore, Engagement::kFree, {}, place}),
      ElementsAre(0xC1, 7, 3, 0, 0, 0, 0, 0, 4, 3, 2, 1, 0xFF, 0xFF, 0xFF, 0xFF, 0xFE, 0xFF, 6, 5, 8, 7));
}

TEST(Codec, RefusesAHeadingBeyondHalfATurn) {  // P-12
  for (const std::int16_t yaw_mrad : {std::int16_t{3143}, std::int16_t{-3143}, std::int16_t{-32768}}) {
    const Wait wait{kThree, Mode::kExplore, Engagement::kFree, {}, Whereabouts{{}, yaw_mrad, 0, 0}};
    EXPECT_EQ(error_in(encode(wait)), DecodeError::kBadValue) << yaw_mrad;
  }
}

TEST(Codec, LaysNegotiationFramesOutAsDocumented) {  // P-11
  EXPECT_THAT(encode(Accept{kSeven, kThree, 0x0102, Mode::kTransport}),
              ElementsAre(0xC1, 2, 7, 0, 3, 0, 0x02, 0x01, 1));
  EXPECT_THAT(encode(AcceptAck{kThree, kSeven, 0x0102}), ElementsAre(0xC1, 3, 3, 0, 7, 0, 0x02, 0x01));
  EXPECT_THAT(encode(Reject{kThree, kSeven, 0x0102, Refusal::kDeclined}),
              ElementsAre(0xC1, 4, 3, 0, 7, 0, 0x02, 0x01, 1));
  EXPECT_THAT(encode(End{kSeven, kThree, 0x0102}), ElementsAre(0xC1, 6, 7, 0, 3, 0, 0x02, 0x01));
}

TEST(Codec, LaysAFragmentOutAsDocumented) {  // P-11
  const PathFragment path{kSeven, kThree, 9, 0x0102, 0x0003, true, 0x0405, {{1, -1}}};
  EXPECT_THAT(encode(path), ElementsAre(0xC1, 5, 7, 0, 3, 0, 9, 0, 0x02, 0x01, 3, 0, 1, 1, 0x05, 0x04, 1, 0,
                                        0, 0, 0xFF, 0xFF, 0xFF, 0xFF));
}

TEST(Codec, RefusesEveryTruncationAndEveryByteTooMany) {  // P-12
  for (const Message& message : examples()) {
    Bytes bytes = encode(message);
    bytes.push_back(0);
    EXPECT_EQ(error_in(bytes), DecodeError::kWrongLength);
    for (bytes.resize(bytes.size() - 2); bytes.size() >= 2; bytes.pop_back()) {
      EXPECT_EQ(error_in(bytes), DecodeError::kWrongLength);
    }
  }
}

TEST(Codec, RefusesOtherProtocolsAndUnknownTypes) {  // P-12
  EXPECT_EQ(error_in({}), DecodeError::kForeign);
  EXPECT_EQ(error_in({0xC2, 1, 3, 0, 0, 0, 0, 0}), DecodeError::kForeign);
  EXPECT_EQ(error_in({0xC1}), DecodeError::kWrongLength);
  EXPECT_EQ(error_in({0xC1, 0}), DecodeError::kUnknownType);
  EXPECT_EQ(error_in({0xC1, 8, 3, 0}), DecodeError::kUnknownType);
}

TEST(Codec, RefusesFieldsOutOfRange) {  // P-12
  EXPECT_EQ(error_in({0xC1, 1, 0, 0, 0, 0, 0, 0}), DecodeError::kBadValue) << "robot 0";
  EXPECT_EQ(error_in({0xC1, 1, 3, 0, 2, 0, 0, 0}), DecodeError::kBadValue) << "mode";
  EXPECT_EQ(error_in({0xC1, 1, 3, 0, 0, 4, 0, 0}), DecodeError::kBadValue) << "engagement";
  EXPECT_EQ(error_in({0xC1, 1, 3, 0, 0, 0, 7, 0}), DecodeError::kBadValue) << "free with a partner";
  EXPECT_EQ(error_in({0xC1, 1, 3, 0, 0, 1, 0, 0}), DecodeError::kBadValue) << "negotiating with nobody";
  EXPECT_EQ(error_in({0xC1, 1, 3, 0, 0, 1, 3, 0}), DecodeError::kBadValue) << "negotiating with itself";
  EXPECT_EQ(error_in({0xC1, 2, 7, 0, 7, 0, 9, 0, 0}), DecodeError::kBadValue) << "to itself";
  EXPECT_EQ(error_in({0xC1, 2, 7, 0, 0, 0, 9, 0, 0}), DecodeError::kBadValue) << "to robot 0";
  EXPECT_EQ(error_in({0xC1, 2, 7, 0, 3, 0, 0, 0, 0}), DecodeError::kBadValue) << "session 0";
  EXPECT_EQ(error_in({0xC1, 2, 7, 0, 3, 0, 9, 0, 2}), DecodeError::kBadValue) << "mode";
  EXPECT_EQ(error_in({0xC1, 4, 7, 0, 3, 0, 9, 0, 2}), DecodeError::kBadValue) << "refusal";
}

TEST(Codec, RefusesFragmentsThatContradictThemselves) {  // P-12
  const auto fragment = [](std::uint16_t total, std::uint16_t first, std::uint8_t heard, std::uint8_t count,
                           std::uint16_t holds) {
    Bytes bytes{0xC1, 5, 7, 0, 3, 0, 9, 0};
    const auto u16 = [&bytes](std::uint16_t value) {
      bytes.push_back(static_cast<std::uint8_t>(value & 0xFFU));
      bytes.push_back(static_cast<std::uint8_t>(value >> 8U));
    };
    u16(total);
    u16(first);
    bytes.push_back(heard);
    bytes.push_back(count);
    u16(holds);
    bytes.resize(bytes.size() + std::size_t{count} * 8);
    return bytes;
  };
  EXPECT_TRUE(message_in(fragment(5, 3, 1, 2, 0)));
  EXPECT_EQ(error_in(fragment(1, 0, 1, 1, 0)), DecodeError::kBadValue) << "a path of one point";
  EXPECT_EQ(error_in(fragment(5, 4, 1, 2, 0)), DecodeError::kBadValue) << "beyond the end";
  EXPECT_EQ(error_in(fragment(65535, 65535, 1, 1, 0)), DecodeError::kBadValue) << "beyond the end";
  EXPECT_EQ(error_in(fragment(0, 0, 1, 1, 0)), DecodeError::kBadValue) << "points of no path";
  EXPECT_EQ(error_in(fragment(5, 3, 2, 2, 0)), DecodeError::kBadValue) << "flag";
  EXPECT_EQ(error_in(fragment(5, 3, 0, 2, 1)), DecodeError::kBadValue) << "holds but has not heard";
}

TEST(Codec, FitsTheMtu) {  // P-13
  EXPECT_EQ(points_that_fit(250), 29U);
  EXPECT_EQ(points_that_fit(32), 2U);
  EXPECT_EQ(points_that_fit(15), 0U);
  EXPECT_EQ(points_that_fit(65535), 255U);
  for (const std::uint32_t mtu : {32U, 100U, 176U, 250U, 3000U}) {
    const PathFragment full{kSeven, kThree, 9, 300, 0, true, 0, std::vector<GridPoint>(points_that_fit(mtu))};
    EXPECT_LE(encode(full).size(), mtu);
  }
}

}  // namespace
}  // namespace caravan::agent
