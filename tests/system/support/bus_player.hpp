// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "idl/robot_types.hpp"
#include "idl/stamp.hpp"
#include "idl/world_types.hpp"
#include "runtime/bus/bus.hpp"
#include "tests/system/support/process.hpp"

/// The test itself on the bus, in place of one of the processes.
namespace caravan::test {

/// Collects the samples of one topic, on its own participant.
template <typename PubSubType>
class Collector {
 public:
  using Sample = typename PubSubType::type;

  Collector(const runtime::BusConfig& bus, const idl::Topic& topic, std::uint32_t robot = 0) : bus_{bus} {
    bus_.reader<PubSubType>(topic, robot, [this](const Sample& sample, const runtime::ParticipantId&) {
      const std::lock_guard lock{mutex_};
      samples_.push_back(sample);
    });
  }
  [[nodiscard]] std::vector<Sample> samples() const {
    const std::lock_guard lock{mutex_};
    return samples_;
  }
  /// The first sample for which `wanted(sample)` holds, none if there is none within `kPatience`.
  template <typename Wanted>
  [[nodiscard]] std::optional<Sample> first(Wanted wanted) const {
    std::optional<Sample> found;
    (void)eventually(
        [&] {
          for (const Sample& sample : samples()) {
            if (wanted(sample)) found = sample;
            if (found) return true;
          }
          return false;
        },
        kPatience);
    return found;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<Sample> samples_;
  runtime::Bus bus_;  // last, so that no callback outlives the rest
};

}  // namespace caravan::test
