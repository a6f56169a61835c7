// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "idl/robot_types.hpp"
#include "idl/world_types.hpp"
#include "runtime/bus/bus.hpp"

namespace caravan::deploy {

/// What an observer does with what it hears of a run. Called on the bus's receiving thread.
struct Listener {
  std::function<void(const caravan_interfaces::msg::WorldTruth&)> truth;
  std::function<void(const caravan_interfaces::msg::WorldStatus&)> world;
  std::function<void(const caravan_interfaces::msg::RadioStatus&)> radio;
  std::function<void(std::uint32_t robot, const caravan_interfaces::msg::Telemetry&)> telemetry;
};

/// Reads everything that observers may read, of robots 1 .. `robots`.
void listen(runtime::Bus& bus, std::uint32_t robots, Listener listener);

}  // namespace caravan::deploy
