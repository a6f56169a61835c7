// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "deploy/doctor/facts.hpp"

namespace caravan::deploy {

struct Finding {
  enum class Severity : std::uint8_t {
    kGood,
    kWarning,  ///< a run works, but worse
    kProblem   ///< the wanted run will not work
  };
  Severity severity = Severity::kGood;
  std::string subject;
  std::string seen;
  std::string advice;  ///< what to do; empty if good
};

/// One finding for each subject, in the order of the facts.
[[nodiscard]] std::vector<Finding> examine(const HostFacts& facts);

/// Space that one process uses in /dev/shm; measured 0.63 MB.
inline constexpr std::uint64_t kSharedMemoryOfAProcess = 1 << 20;
/// Socket buffer size in the project's DDS profiles.
inline constexpr std::uint64_t kSocketBytes = 1 << 20;

}  // namespace caravan::deploy
