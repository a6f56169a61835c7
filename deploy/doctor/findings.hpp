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
    kWarning,  ///< works, but something will be worse for it
    kProblem   ///< a run as it is wanted will not work
  };
  Severity severity = Severity::kGood;
  std::string subject;
  std::string seen;
  std::string advice;  ///< what to do; empty when it is good
};

/// One finding for each subject, in the order of the facts.
[[nodiscard]] std::vector<Finding> examine(const HostFacts& facts);

/// What one process keeps in /dev/shm, for room for a whole run: measured 0.63 MB.
inline constexpr std::uint64_t kSharedMemoryOfAProcess = 1 << 20;
/// Of the project's DDS profiles.
inline constexpr std::uint64_t kSocketBytes = 1 << 20;

}  // namespace caravan::deploy
