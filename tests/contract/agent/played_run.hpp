// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "idl/robot_types.hpp"
#include "runtime/bus/bus.hpp"
#include "runtime/host/domain_lock.hpp"
#include "runtime/host/shared_memory.hpp"
#include "tests/system/support/process.hpp"

/// The agent contract suite plays the world and the radio of one robot, and looks at what its agent answers.
namespace caravan::test {

using namespace std::chrono_literals;
namespace msg = caravan_interfaces::msg;

inline constexpr std::uint32_t kRobot = 1;
inline constexpr std::chrono::milliseconds kStep{32};

/// The agent under test, from the command line of the suite.
struct Subject {
  std::filesystem::path program;
  std::vector<std::string> more;   ///< arguments after those of every agent
  std::filesystem::path scenario;  ///< empty: one of the suite's own
  runtime::Transport transport;
  std::chrono::milliseconds patience = kPatience;  ///< for one answer
};
[[nodiscard]] Subject& subject();

/// The sensor frame of step `step`: everything that it tells changes from step to step.
[[nodiscard]] msg::SensorFrame frame_of(std::uint64_t session, int step);

/// Ends with this object, by SIGTERM.
class AgentUnderTest : public PatientProcess {
 public:
  using PatientProcess::PatientProcess;
  ~AgentUnderTest();
  AgentUnderTest(const AgentUnderTest&) = delete;
  AgentUnderTest& operator=(const AgentUnderTest&) = delete;
};

/// The world, as one participant with the writer of the sensor frames.
class PlayedWorld {
 public:
  explicit PlayedWorld(const runtime::BusConfig& bus);
  void send(msg::SensorFrame frame) { frames_.write(frame); }
  /// The agent has been found.
  [[nodiscard]] bool has_reader() const;

 private:
  mutable std::mutex mutex_;
  bool has_reader_ = false;
  runtime::Bus bus_;
  runtime::Writer<msg::SensorFramePubSubType> frames_;
};

/// The radio, likewise.
class PlayedRadio {
 public:
  explicit PlayedRadio(const runtime::BusConfig& bus);
  /// A frame of another robot that belongs to this step.
  void send(std::uint64_t session, int step);

 private:
  runtime::Bus bus_;
  runtime::Writer<msg::RadioReceivePubSubType> receives_;
};

/// All that the agent has said in answer to one frame.
struct Answer {
  std::vector<msg::RobotCommand> commands;
  std::vector<msg::RadioTransmit> transmits;
  std::vector<msg::Telemetry> telemetry;
  std::string order;  ///< T, C and R for telemetry, command, radio as they came
};

/// Notes what an agent says, and whether it is there.
class Listener {
 public:
  explicit Listener(const runtime::BusConfig& bus);

  [[nodiscard]] Answer answer(std::uint64_t session, int step) const;
  /// Numbers of the steps, and of the sessions, that anything said so far belongs to.
  [[nodiscard]] std::set<std::int64_t> steps() const;
  [[nodiscard]] std::set<std::uint64_t> sessions() const;
  /// Participants that write the robot's commands.
  [[nodiscard]] std::size_t agents() const;
  /// That they state in discovery; of the newest.
  [[nodiscard]] runtime::Identity identity() const;
  /// An agent reads the robot's radio.
  [[nodiscard]] bool uses_radio() const;

 private:
  using Key = std::pair<std::uint64_t, std::int64_t>;  // session, stamp in ns
  template <typename Sample>
  void note(const Sample& sample, std::vector<Sample> Answer::*samples, char letter);
  void meet(const runtime::Discovery& news);

  mutable std::mutex mutex_;
  std::map<Key, Answer> answers_;
  std::set<runtime::ParticipantId> agents_;
  runtime::Identity identity_;
  bool uses_radio_ = false;
  runtime::Bus bus_;  // last, so that no callback outlives the rest
};

/// A run of one robot in a domain of its own.
class AgentContract : public ::testing::Test {
 protected:
  /// Started as by `caravan run --agent`.
  [[nodiscard]] std::unique_ptr<AgentUnderTest> start_agent();
  [[nodiscard]] runtime::BusConfig bus(const std::string& role) const;
  /// Waits for the command, or the transmission, that answers a step.
  [[nodiscard]] bool commands(std::uint64_t session, int step, std::size_t times = 1) const;
  [[nodiscard]] bool transmits(std::uint64_t session, int step) const;
  /// Steps `from` to `to`, each sent when the one before has been answered.
  void drive(std::uint64_t session, int from, int to);
  /// False: the agent does not read its radio, as far as can be seen.
  [[nodiscard]] bool agent_uses_radio() const;
  /// What to print when an answer is missing.
  [[nodiscard]] std::string log() const;

  const runtime::DomainLock lock_{std::nullopt};
  const ScratchFolder folder_;
  runtime::SharedMemory leftovers_{lock_.domain()};  // of agents that are killed
  int started_ = 0;
  Listener listener_{bus("observer")};
  std::unique_ptr<PlayedWorld> world_ = std::make_unique<PlayedWorld>(bus("world_server"));
};

}  // namespace caravan::test
