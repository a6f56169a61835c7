// SPDX-License-Identifier: Apache-2.0
#include "world_server/shell/outputs.hpp"

#include "idl/stamp.hpp"
#include "runtime/control/reply.hpp"
#include "world_server/shell/wire.hpp"

namespace caravan::world {
namespace msg = caravan_interfaces::msg;

namespace {

std::vector<runtime::Writer<msg::SensorFramePubSubType>> sensor_writers(const WorldConfig& config,
                                                                        runtime::Bus& bus) {
  std::vector<runtime::Writer<msg::SensorFramePubSubType>> writers;
  for (std::uint32_t robot = 1; robot <= config.robots.count; ++robot) {
    const idl::Topic& topic = config.is_body(robot) ? idl::kBodySensors : idl::kSensors;
    writers.push_back(bus.writer<msg::SensorFramePubSubType>(topic, robot));
  }
  return writers;
}

}  // namespace

Outputs::Outputs(const WorldConfig& config, std::uint64_t session, Time period, runtime::Bus& bus)
    : session_{session},
      period_{period},
      sensors_{sensor_writers(config, bus)},
      truths_{bus.writer<msg::WorldTruthPubSubType>(idl::kTruth)},
      clock_{bus.writer<rosgraph_msgs::msg::ClockPubSubType>(idl::kClock)},
      statuses_{bus.writer<msg::WorldStatusPubSubType>(idl::kWorldStatus)},
      replies_{bus.writer<msg::ControlReplyPubSubType>(idl::kControlReply)} {}

void Outputs::sensors(World& world, Time stamp, const std::vector<bool>& radio_due,
                      std::chrono::nanoseconds& sensing) {
  rosgraph_msgs::msg::Clock clock;
  clock.clock(idl::to_wire(stamp));
  clock_.write(clock);  // a lost sample of it does not matter
  frame_.stamp(idl::to_wire(stamp));
  frame_.session(session_);
  for (std::uint32_t robot = 1; robot <= sensors_.size(); ++robot) {
    if (!world.is_present(robot)) continue;
    {
      const Stopwatch watch{sensing};
      to_wire(world.sense(robot), frame_);
    }
    frame_.radio_due(radio_due[robot - 1]);
    count(sensors_[robot - 1].write(frame_));
  }
}

void Outputs::truth(const World& world, std::span<const std::uint32_t> members,
                    std::span<const std::uint32_t> reported, Time stamp, bool last) {
  to_wire(world, members, truth_);
  truth_.reported().assign(reported.begin(), reported.end());
  truth_.stamp(idl::to_wire(stamp));
  truth_.next_stamp(idl::to_wire(stamp + period_));
  truth_.session(session_);
  truth_.last(last);
  count(truths_.write(truth_));
}

void Outputs::status(msg::WorldStatus& status) { count(statuses_.write(status)); }

void Outputs::replies(const std::vector<Outcome>& outcomes) {
  for (const Outcome& outcome : outcomes) {
    runtime::log_outcome(outcome);
    msg::ControlReply reply = runtime::to_reply(outcome, session_);
    count(replies_.write(reply));
  }
}

}  // namespace caravan::world
