// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/compatibility.hpp"

#include <gmock/gmock.h>

namespace caravan::runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Durability = EndpointQos::Durability;

TEST(WriterLacks, NothingBetweenOurOwn) {
  for (const idl::Topic& topic : idl::kTopics) EXPECT_EQ(writer_lacks(qos_of(topic), qos_of(topic)), "");
}

TEST(WriterLacks, NamesEachThatIsMissing) {
  EndpointQos writer = qos_of(idl::kCommand);
  writer.reliable = false;
  writer.durability = Durability::kVolatile;
  EXPECT_THAT(writer_lacks(writer, qos_of(idl::kCommand)),
              AllOf(HasSubstr("BEST_EFFORT, the reader needs RELIABLE"),
                    HasSubstr("VOLATILE, the reader needs TRANSIENT_LOCAL")));
}

TEST(WriterLacks, TypeRepresentationOwnershipAndPartition) {
  const EndpointQos reader = qos_of(idl::kCommand);
  const auto with = [&](auto change) {
    EndpointQos writer = reader;
    change(writer);
    return writer_lacks(writer, reader);
  };
  EXPECT_THAT(with([](EndpointQos& qos) { qos.type = "std_msgs::msg::dds_::String_"; }),
              AllOf(HasSubstr("std_msgs::msg::dds_::String_"), HasSubstr("RobotCommand_")));
  EXPECT_THAT(with([](EndpointQos& qos) { qos.xcdr1 = false; }), HasSubstr("XCDR2 only"));
  EXPECT_THAT(with([](EndpointQos& qos) { qos.exclusive = true; }), HasSubstr("EXCLUSIVE"));
  EXPECT_THAT(with([](EndpointQos& qos) { qos.in_partition = true; }), HasSubstr("partition"));
}

TEST(WriterLacks, NothingWhenItOffersMoreThanIsNeeded) {
  EndpointQos writer = qos_of(idl::kClock);
  writer.reliable = true;
  writer.durability = Durability::kPersistent;
  EXPECT_EQ(writer_lacks(writer, qos_of(idl::kClock)), "");
}

TEST(WriterLacks, TakesADurabilityThatThereIsNot) {
  EndpointQos reader = qos_of(idl::kCommand);
  reader.durability = static_cast<Durability>(200);
  EXPECT_THAT(writer_lacks(qos_of(idl::kCommand), reader), HasSubstr("of unknown kind"));
}

}  // namespace
}  // namespace caravan::runtime
