// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "world_server/barrier/barrier.hpp"

namespace caravan::world {

/// Totals for the status.
struct Tallies {
  explicit Tallies(std::uint32_t robots) : refused_commands(robots), clamped_commands(robots) {}

  std::vector<std::uint64_t> refused_commands;  // by robot, [0] is robot 1
  std::vector<std::uint64_t> clamped_commands;
  std::uint64_t stale_samples = 0;
  std::uint64_t physics_complaints = 0;  // steps with a warning of the solver
  std::chrono::nanoseconds physics{0};
  std::chrono::nanoseconds sensors{0};
  Wall started{};
  Wall ended{};
  std::uint64_t steps_at_status = 0;
  Wall last_status{};
};

/// Adds its lifetime to a tally.
class Stopwatch {
 public:
  explicit Stopwatch(std::chrono::nanoseconds& tally)
      : tally_{tally}, began_{std::chrono::steady_clock::now()} {}
  ~Stopwatch() { tally_ += std::chrono::steady_clock::now() - began_; }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  std::chrono::nanoseconds& tally_;
  Wall began_;
};

}  // namespace caravan::world
