// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/checked_type.hpp"

#include <gtest/gtest.h>

#include <random>

#include "idl/control_types.hpp"
#include "idl/robot_types.hpp"
#include "idl/world_types.hpp"
#include "tests/rogue/raw_type.hpp"

namespace caravan::runtime {
namespace {

namespace msg = caravan_interfaces::msg;
using test::Bytes;
using test::bytes_of;

/// The reason why a sample with these bytes is refused.
template <typename Type>
std::optional<Refusal> read(const Bytes& bytes, typename Type::type* into = nullptr) {
  CheckedType<Type> type;
  typename Type::type sample;
  test::Payload payload{static_cast<std::uint32_t>(bytes.size())};
  EXPECT_TRUE(test::write_bytes(bytes, payload));
  EXPECT_TRUE(type.read(payload, into == nullptr ? &sample : into));
  return detail::refusal_of_this_thread();
}

TEST(CheckedType, ReadsWhatIsOfTheType) {
  msg::RobotCommand command;
  command.left_mps(0.25);
  command.gripper_closed(true);
  msg::RobotCommand seen;

  EXPECT_EQ(read<msg::RobotCommandPubSubType>(bytes_of<msg::RobotCommandPubSubType>(command), &seen),
            std::nullopt);
  EXPECT_EQ(seen, command);
}

TEST(CheckedType, RefusesABooleanThatIsNeither0Nor1) {
  Bytes bytes = bytes_of<msg::RobotCommandPubSubType>({});
  bytes.back() = 2;

  EXPECT_EQ(read<msg::RobotCommandPubSubType>(bytes), Refusal::kMalformed);
}

TEST(CheckedType, RefusesLengthsBeyondItsBytesAndKeepsNoMemory) {
  Bytes bytes = bytes_of<msg::TelemetryPubSubType>({});
  constexpr std::size_t kPathLength = 4 + 8 + 8 + 4 + 4 + 8 + 4;
  for (std::size_t i = 0; i < 4; ++i) bytes.at(kPathLength + i) = 0xff;
  msg::Telemetry telemetry;
  telemetry.path().resize(1000);  // left from the sample before

  EXPECT_EQ(read<msg::TelemetryPubSubType>(bytes, &telemetry), Refusal::kMalformed);
  EXPECT_EQ(telemetry.path().capacity(), 0U);
}

TEST(CheckedType, RefusesWhatIsTooShortTooLongOrNothing) {
  Bytes bytes = bytes_of<msg::WorldTruthPubSubType>({});
  bytes.resize(bytes.size() / 2);

  EXPECT_EQ(read<msg::WorldTruthPubSubType>(bytes), Refusal::kMalformed);
  EXPECT_EQ(read<msg::WorldTruthPubSubType>({}), Refusal::kMalformed);
  EXPECT_EQ(read<msg::WorldTruthPubSubType>(Bytes(kMostBytes + 4)), Refusal::kTooLong);
}

TEST(CheckedType, AGoodSampleAfterABadOneCounts) {
  (void)read<msg::RobotCommandPubSubType>({});

  EXPECT_EQ(read<msg::RobotCommandPubSubType>(bytes_of<msg::RobotCommandPubSubType>({})), std::nullopt);
}

template <typename Type>
void expect_whole_only(const typename Type::type& sample) {
  const Bytes bytes = bytes_of<Type>(sample);
  EXPECT_EQ(read<Type>(bytes), std::nullopt);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const Bytes start(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
    EXPECT_EQ(read<Type>(start), Refusal::kMalformed) << length << " of " << bytes.size() << " bytes";
  }
}

template <typename... Types>
struct Each {
  static void expect_empty_ones_whole_only() { (expect_whole_only<Types>({}), ...); }
  static void read_all(const Bytes& bytes) { (((void)read<Types>(bytes)), ...); }
};
using All = Each<msg::SensorFramePubSubType, msg::RobotCommandPubSubType, msg::RadioTransmitPubSubType,
                 msg::RadioReceivePubSubType, msg::TelemetryPubSubType, msg::WorldTruthPubSubType,
                 msg::RadioStepPubSubType, msg::WorldStatusPubSubType, msg::RadioStatusPubSubType,
                 msg::RunCreditPubSubType, msg::ControlRequestPubSubType, msg::ControlReplyPubSubType>;

TEST(CheckedType, RefusesWhatEndsAnywhereBeforeItsEnd) {
  All::expect_empty_ones_whole_only();
  msg::Telemetry telemetry;
  telemetry.path().resize(2);
  telemetry.events().resize(2);
  telemetry.events()[0].name("odd");
  expect_whole_only<msg::TelemetryPubSubType>(telemetry);
  msg::RadioTransmit transmit;
  transmit.frames().resize(3);
  transmit.frames()[1].bytes().resize(5);
  expect_whole_only<msg::RadioTransmitPubSubType>(transmit);
  msg::ControlReply reply;
  reply.reason("a reason");
  expect_whole_only<msg::ControlReplyPubSubType>(reply);
}

TEST(CheckedType, TakesAnyBytes) {
  for (std::uint32_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random{seed};
    Bytes bytes(random() % 600);
    // Small numbers are valid lengths, so that the bytes after them are read, too.
    for (std::uint8_t& byte : bytes)
      byte = static_cast<std::uint8_t>(random() % 4 == 0 ? random() : random() % 3);
    if (bytes.size() >= 4) bytes[0] = 0, bytes[1] = static_cast<std::uint8_t>(random() % 4);
    All::read_all(bytes);
  }
}

}  // namespace
}  // namespace caravan::runtime
