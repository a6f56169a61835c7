// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "idl/control_types.hpp"
#include "idl/robot_types.hpp"
#include "idl/stamp.hpp"
#include "idl/world_types.hpp"
#include "tests/rogue/raw_type.hpp"

namespace caravan::test {

/// A stranger's knowledge of a run: the latest truth.
struct Known {
  std::uint64_t session = 0;
  std::chrono::nanoseconds stamp{0};
  std::chrono::nanoseconds next_stamp{0};
};

/// Creates samples that do harm where they are accepted. Deterministic for a seed and a Known.
class Forger {
 public:
  Forger(std::uint32_t seed, std::uint32_t robots) : random_{seed}, robots_{robots} {}

  void know(const Known& known) { known_ = known; }
  [[nodiscard]] std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(random_() % end); }

  /// Fills a sample of the topic's type with forged stamps, sessions and other values that matter.
  void forge(caravan_interfaces::msg::SensorFrame& frame);
  void forge(caravan_interfaces::msg::RobotCommand& command);
  void forge(caravan_interfaces::msg::RadioTransmit& transmit);
  void forge(caravan_interfaces::msg::RadioReceive& receive);
  void forge(caravan_interfaces::msg::Telemetry& telemetry);
  void forge(caravan_interfaces::msg::WorldTruth& truth);
  void forge(caravan_interfaces::msg::RadioStep& step);
  void forge(caravan_interfaces::msg::WorldStatus& status);
  void forge(caravan_interfaces::msg::RadioStatus& status);
  void forge(caravan_interfaces::msg::RunCredit& credit);
  void forge(caravan_interfaces::msg::ControlRequest& request);
  void forge(caravan_interfaces::msg::ControlReply& reply);
  template <typename Sample>
  void forge(Sample&) {}  // the clock

  /// Corrupts some of a sample's bytes: lengths, booleans, anything.
  void spoil(Bytes& bytes);
  /// Random bytes.
  [[nodiscard]] Bytes noise();

 private:
  /// The present stamp, the next, a later one, or the last possible.
  [[nodiscard]] std::chrono::nanoseconds stamp();
  [[nodiscard]] std::uint64_t session();
  [[nodiscard]] double real();
  [[nodiscard]] Bytes payload();
  template <typename Sample>
  void date(Sample& sample) {
    sample.stamp(idl::to_wire(stamp()));
    sample.session(session());
  }

  std::mt19937 random_;
  std::uint32_t robots_;
  Known known_;
};

}  // namespace caravan::test
