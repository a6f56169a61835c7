// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

/// The table of topics that every process uses: name, type, quality of service, who may write, who may
/// read.
namespace caravan::idl {

enum class Party : std::uint8_t {
  kWorld,
  kRadio,
  kAgent,
  kObserver,
  kBridge,        ///< in place of world or radio: between an agent and a real robot or a real radio
  kEmulatedRobot  ///< the peer of a bridge when there is no real robot
};

/// How a topic's samples are delivered. All but kLatest are RELIABLE, all but kLatest and kRequest
/// TRANSIENT_LOCAL.
enum class Delivery : std::uint8_t {
  kStep,      ///< in the step's path: shallow history
  kObserved,  ///< must not be lost by a late observer: a history longer than the world may run ahead
  kHealth,    ///< only the latest few matter
  kRequest,   ///< only for present processes: one that starts later never receives it
  kLatest     ///< BEST_EFFORT, VOLATILE, only the latest
};

struct Topic {
  std::string_view name;  ///< "<i>" is replaced by the robot's number
  std::string_view type;  ///< as on the wire
  Delivery delivery;
  std::array<Party, 2> writers;  ///< a single writer is listed twice
  std::array<Party, 2> readers;
};

/// The world runs at most this many steps ahead of a credited observer.
inline constexpr std::uint32_t kMaxStepsAhead = 256;

inline constexpr Topic kSensors{"rt/robot_<i>/sensors",
                                "caravan_interfaces::msg::dds_::SensorFrame_",
                                Delivery::kStep,
                                {Party::kWorld, Party::kBridge},
                                {Party::kAgent, Party::kAgent}};
inline constexpr Topic kCommand{"rt/robot_<i>/command",
                                "caravan_interfaces::msg::dds_::RobotCommand_",
                                Delivery::kStep,
                                {Party::kAgent, Party::kAgent},
                                {Party::kWorld, Party::kBridge}};
inline constexpr Topic kRadioTransmit{"rt/robot_<i>/radio/tx",
                                      "caravan_interfaces::msg::dds_::RadioTransmit_",
                                      Delivery::kStep,
                                      {Party::kAgent, Party::kAgent},
                                      {Party::kRadio, Party::kBridge}};
inline constexpr Topic kRadioReceive{"rt/robot_<i>/radio/rx",
                                     "caravan_interfaces::msg::dds_::RadioReceive_",
                                     Delivery::kStep,
                                     {Party::kRadio, Party::kBridge},
                                     {Party::kAgent, Party::kAgent}};
inline constexpr Topic kTelemetry{"rt/robot_<i>/telemetry",
                                  "caravan_interfaces::msg::dds_::Telemetry_",
                                  Delivery::kObserved,
                                  {Party::kAgent, Party::kAgent},
                                  {Party::kObserver, Party::kObserver}};
inline constexpr Topic kTruth{"rt/world/truth",
                              "caravan_interfaces::msg::dds_::WorldTruth_",
                              Delivery::kObserved,
                              {Party::kWorld, Party::kWorld},
                              {Party::kRadio, Party::kObserver}};
inline constexpr Topic kRadioStep{"rt/radio/step",
                                  "caravan_interfaces::msg::dds_::RadioStep_",
                                  Delivery::kStep,
                                  {Party::kRadio, Party::kRadio},
                                  {Party::kWorld, Party::kWorld}};
inline constexpr Topic kClock{"rt/clock",
                              "rosgraph_msgs::msg::dds_::Clock_",
                              Delivery::kLatest,
                              {Party::kWorld, Party::kWorld},
                              {Party::kObserver, Party::kObserver}};
inline constexpr Topic kWorldStatus{"rt/world/status",
                                    "caravan_interfaces::msg::dds_::WorldStatus_",
                                    Delivery::kHealth,
                                    {Party::kWorld, Party::kWorld},
                                    {Party::kObserver, Party::kObserver}};
inline constexpr Topic kRadioStatus{"rt/radio/status",
                                    "caravan_interfaces::msg::dds_::RadioStatus_",
                                    Delivery::kHealth,
                                    {Party::kRadio, Party::kRadio},
                                    {Party::kObserver, Party::kObserver}};
inline constexpr Topic kRunCredit{"rt/run/credit",
                                  "caravan_interfaces::msg::dds_::RunCredit_",
                                  Delivery::kHealth,
                                  {Party::kObserver, Party::kObserver},
                                  {Party::kWorld, Party::kWorld}};
inline constexpr Topic kControlRequest{"rt/control/request",
                                       "caravan_interfaces::msg::dds_::ControlRequest_",
                                       Delivery::kRequest,
                                       {Party::kObserver, Party::kObserver},
                                       {Party::kWorld, Party::kRadio}};
inline constexpr Topic kControlReply{"rt/control/reply",
                                     "caravan_interfaces::msg::dds_::ControlReply_",
                                     Delivery::kObserved,
                                     {Party::kWorld, Party::kRadio},
                                     {Party::kObserver, Party::kObserver}};

/// In place of sensors and command for a robot that is a body: its agent's topics are a bridge's to serve.
inline constexpr Topic kBodySensors{"rt/body_<i>/sensors",
                                    "caravan_interfaces::msg::dds_::SensorFrame_",
                                    Delivery::kStep,
                                    {Party::kWorld, Party::kWorld},
                                    {Party::kEmulatedRobot, Party::kEmulatedRobot}};
inline constexpr Topic kBodyCommand{"rt/body_<i>/command",
                                    "caravan_interfaces::msg::dds_::RobotCommand_",
                                    Delivery::kStep,
                                    {Party::kEmulatedRobot, Party::kEmulatedRobot},
                                    {Party::kWorld, Party::kWorld}};

inline constexpr std::array kTopics{kSensors,   kCommand,        kRadioTransmit, kRadioReceive, kTelemetry,
                                    kTruth,     kRadioStep,      kClock,         kWorldStatus,  kRadioStatus,
                                    kRunCredit, kControlRequest, kControlReply,  kBodySensors,  kBodyCommand};

/// The topic's name for one robot.
[[nodiscard]] inline std::string name_for(const Topic& topic, std::uint32_t robot) {
  std::string name{topic.name};
  const std::size_t place = name.find("<i>");
  return place == std::string::npos ? name : name.replace(place, 3, std::to_string(robot));
}

}  // namespace caravan::idl
