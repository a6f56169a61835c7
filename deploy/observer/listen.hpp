// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "idl/robot_types.hpp"
#include "idl/world_types.hpp"
#include "runtime/bus/bus.hpp"
#include "runtime/bus/tenure.hpp"

namespace caravan::deploy {

/// An observer's handlers of a run's samples. Called on the bus's receiving thread.
struct Listener {
  std::function<void(const caravan_interfaces::msg::WorldTruth&)> truth;
  std::function<void(const caravan_interfaces::msg::WorldStatus&)> world;
  std::function<void(const caravan_interfaces::msg::RadioStatus&)> radio;
  std::function<void(std::uint32_t robot, const caravan_interfaces::msg::Telemetry&)> telemetry;
};

/// Reads everything that observers may read, of robots 1 .. `robots`, from the participants that hold the
/// roles: the world, the radio, each robot's agent. The world alone defines the running session.
class RunReaders {
 public:
  enum class Worlds : std::uint8_t {
    kOne,  ///< only the first: when it has gone no other is accepted
    kNext  ///< another one may follow it
  };
  RunReaders(std::uint32_t robots, Worlds worlds, Listener listener);

  /// Passes on discoveries of the bus; from any thread.
  void discovered(const runtime::Discovery& news);
  /// Creates the readers. `bus` must be closed before this object is destroyed.
  void join(runtime::Bus& bus);

  /// Participants that write topics to agents in place of the world or the radio.
  [[nodiscard]] std::vector<std::string> impostors() const;

 private:
  using Telemetry = caravan_interfaces::msg::Telemetry;
  struct Early {
    runtime::Sender sender;
    Telemetry sample;
  };
  struct Agent {
    runtime::Tenure tenure;
    std::deque<Early> early;  // of a session that the world has not announced yet
  };

  /// Passes `sample` on if `sender` holds the role, else keeps it for when it does.
  template <typename Sample>
  void on_world(const idl::Topic& topic, const Sample& sample, const runtime::Sender& sender,
                const std::function<void(const Sample&)>& handle);
  void on_radio(const caravan_interfaces::msg::RadioStatus& sample, const runtime::Sender& sender);
  void on_telemetry(std::uint32_t robot, const Telemetry& sample, const runtime::Sender& sender);
  void take_telemetry(std::uint32_t robot, const Telemetry& sample, const runtime::Sender& sender);
  void follow_session(std::uint64_t session);
  /// Releases the roles of participants that have gone.
  void read_news();
  void forget(const runtime::Discovery& gone);
  void hand_over(runtime::Tenure& tenure);

  const Worlds worlds_;
  const Listener listener_;
  runtime::Bus* bus_ = nullptr;

  mutable std::mutex news_mutex_;
  std::vector<runtime::Discovery> news_;
  std::map<std::string, const idl::Topic*> of_agents_;  // topics that agents read, by name
  std::set<std::string> impostors_;

  std::mutex mutex_;
  std::uint64_t session_ = 0;
  runtime::Tenure world_;
  runtime::Tenure radio_;
  std::vector<Agent> agents_;  // [0] is robot 1
};

}  // namespace caravan::deploy
