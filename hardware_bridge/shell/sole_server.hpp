// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "idl/topics.hpp"
#include "runtime/bus/bus.hpp"
#include "runtime/bus/clash.hpp"
#include "runtime/process/loop.hpp"

namespace caravan::bridge {

/// Ensures that one bridge serves a robot in a DDS domain, on whatever hosts and ports: the first one stays
/// (see runtime::Clash). The same applies to modems and emulated robots.
///
/// Not thread-safe.
class SoleServer {
 public:
  /// @param topic  topic that each of them writes for its robot
  SoleServer(const runtime::Bus& bus, double lease_s, const idl::Topic& topic, std::uint32_t robot);

  /// Call with every discovery event. @param in_use  this process already serves an agent
  void see(const runtime::Discovery& news, bool in_use);
  /// Another process serves the robot: write nothing.
  [[nodiscard]] bool must_be_silent() const { return clash_.must_be_silent(); }
  [[nodiscard]] std::optional<runtime::WallTime> next_deadline() const { return clash_.deadline(); }
  /// Why this process must end; empty: it need not.
  [[nodiscard]] std::string lost() const;

 private:
  const idl::Topic& topic_;
  std::uint32_t robot_;
  runtime::Clash clash_;
};

}  // namespace caravan::bridge
