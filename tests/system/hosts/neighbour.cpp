// SPDX-License-Identifier: Apache-2.0
// neighbour DOMAIN: a DDS program that, like a ROS 2 node, does not use the bus and settings of this project.
// Its exit code is 0 when it has received the clock, and 1 when it has not within ten minutes.
#include "idl/clock_types.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include "runtime/bus/fastdds_version.hpp"

namespace fast = eprosima::fastdds::dds;

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  auto* factory = fast::DomainParticipantFactory::get_instance();
  auto* participant = factory->create_participant(static_cast<std::uint32_t>(std::atoi(argv[1])),
                                                  fast::PARTICIPANT_QOS_DEFAULT);
  if (participant == nullptr) return 2;
  const fast::TypeSupport type{new rosgraph_msgs::msg::ClockPubSubType{}};
  type.register_type(participant);
  fast::DataReader* reader =
      participant->create_subscriber(fast::SUBSCRIBER_QOS_DEFAULT)
          ->create_datareader(
              participant->create_topic("rt/clock", type.get_type_name(), fast::TOPIC_QOS_DEFAULT),
              fast::DATAREADER_QOS_DEFAULT);
  bool heard = false;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes{10};
  while (!heard && std::chrono::steady_clock::now() < deadline) {
    rosgraph_msgs::msg::Clock clock;
    fast::SampleInfo info;
    reader->wait_for_unread_message({1, 0});
    heard = caravan::runtime::is_ok(reader->take_next_sample(&clock, &info)) && info.valid_data;
    if (heard) std::printf("heard the clock at %d.%09u s\n", clock.clock().sec(), clock.clock().nanosec());
  }
  participant->delete_contained_entities();
  factory->delete_participant(participant);
  return heard ? 0 : 1;
}
