// SPDX-License-Identifier: Apache-2.0
// The real world server and writers that are not of our bus, such as those of another vendor.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include "runtime/bus/qos.hpp"
#include "runtime/host/domain_lock.hpp"
#include "tests/system/support/bus_player.hpp"

namespace caravan::test {
namespace {

namespace dds = runtime::dds;
namespace msg = caravan_interfaces::msg;
using namespace std::chrono_literals;
using ::testing::HasSubstr;

/// A participant that states no role, with one writer of a robot's commands.
class ForeignAgent {
 public:
  ForeignAgent(const runtime::BusConfig& bus, std::uint32_t robot, const dds::DataWriterQos& qos) {
    participant_ = factory().create_participant(bus.domain, runtime::participant_qos("/foreign", bus));
    participant_->enable();
    const dds::TypeSupport type{new msg::RobotCommandPubSubType{}};
    type.register_type(participant_);
    dds::Topic* topic = participant_->create_topic(idl::name_for(idl::kCommand, robot), type.get_type_name(),
                                                   dds::TOPIC_QOS_DEFAULT);
    publisher_ = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
    publisher_->enable();
    writer_ = publisher_->create_datawriter(topic, qos);
    writer_->enable();
  }
  ~ForeignAgent() {
    participant_->delete_contained_entities();
    factory().delete_participant(participant_);
  }
  ForeignAgent(const ForeignAgent&) = delete;
  ForeignAgent& operator=(const ForeignAgent&) = delete;

  void write(msg::RobotCommand command) { writer_->write(&command); }
  /// Deletes the writer; the participant stays.
  void delete_writer() { publisher_->delete_datawriter(writer_); }

 private:
  static dds::DomainParticipantFactory& factory() { return *dds::DomainParticipantFactory::get_instance(); }

  dds::DomainParticipant* participant_ = nullptr;
  dds::Publisher* publisher_ = nullptr;
  dds::DataWriter* writer_ = nullptr;
};

class ForeignWriter : public ::testing::Test {
 protected:
  // UDP, where every standard implementation finds the world.
  runtime::DomainLock lock_{std::nullopt};
  ScratchFolder folder_;
  Process world_{{"world_server", "--scenario", scenario("small.toml"), "--domain",
                  std::to_string(lock_.domain()), "--transport", "udp"},
                 folder_ / "world.log"};
  const runtime::BusConfig bus_{
      .role = "observer", .domain = lock_.domain(), .lease_s = 60.0, .transport = runtime::Transport::kUdp};
};

TEST_F(ForeignWriter, ThatDoesNotMatchIsNamedWithWhatItLacks) {
  dds::DataWriterQos qos = runtime::writer_qos(idl::kCommand.delivery);
  qos.durability().kind = dds::VOLATILE_DURABILITY_QOS;
  const ForeignAgent fleeting{bus_, 1, qos};
  qos.reliability().kind = dds::BEST_EFFORT_RELIABILITY_QOS;
  const ForeignAgent careless{bus_, 2, qos};

  EXPECT_TRUE(world_.prints("no match topic=rt/robot_1/command: the writer of participant 01.0f.", kPatience))
      << world_.output();
  EXPECT_TRUE(world_.prints("no match topic=rt/robot_2/command", kPatience)) << world_.output();
  EXPECT_THAT(world_.output(),
              HasSubstr("\"/foreign\" is ignored: the writer's durability is VOLATILE, the reader "
                        "needs TRANSIENT_LOCAL"));
  EXPECT_THAT(world_.output(),
              HasSubstr("the writer's reliability is BEST_EFFORT, the reader needs RELIABLE"));
}

TEST_F(ForeignWriter, ThatIsDeletedHasLeftAtOnceThoughItsParticipantStays) {
  const Collector<msg::SensorFramePubSubType> sensors{bus_, idl::kSensors, 4};
  const auto frame = sensors.first([](const msg::SensorFrame&) { return true; });
  ASSERT_TRUE(frame) << world_.output();
  ForeignAgent agent{bus_, 4, runtime::writer_qos(idl::kCommand.delivery)};
  msg::RobotCommand command;
  command.stamp(frame->stamp());
  command.session(frame->session());
  agent.write(command);
  const Collector<msg::WorldStatusPubSubType> statuses{bus_, idl::kWorldStatus};
  ASSERT_TRUE(statuses.first([](const msg::WorldStatus& one) {
    return one.missing() == std::vector<std::string>{"robot 1", "robot 2", "robot 3"};
  })) << world_.output();

  agent.delete_writer();

  EXPECT_TRUE(world_.prints("robot lost robot=4: participant 01.0f.", kPatience)) << world_.output();
}

}  // namespace
}  // namespace caravan::test
