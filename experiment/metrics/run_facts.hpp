// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiment/metrics/observation.hpp"
#include "runtime/provenance/provenance.hpp"

namespace caravan::experiment {

/// The facts of a run that are known before it begins.
struct RunFacts {
  std::string scenario;              ///< its name
  std::string engine;                ///< dds, embedded
  std::string controller = "paper";  ///< or what its library calls itself
  std::string mode;                  ///< none, partial, full
  std::uint64_t seed = 1;
  std::uint32_t robots = 0;
  std::uint32_t items = 0;  ///< deliveries that end it; 0: only max_time ends it
  Time max_time{0};         ///< simulated
  runtime::Provenance provenance = {};
};

/// Wall time spent in the parts of a run, seconds.
struct TimeSplit {
  double physics_s = 0.0;
  double sensors_s = 0.0;
  double radio_s = 0.0;
  double agents_s = 0.0;
  double transport_s = 0.0;
};

/// Commands and frames that were refused or lost in the whole run.
struct Refusals {
  std::uint64_t commands_refused = 0;  ///< a speed was not finite: both wheels stopped
  std::uint64_t commands_clamped = 0;  ///< beyond the wheel limit
  std::uint64_t frames_over_mtu = 0;
  std::uint64_t frames_on_bad_channel = 0;
  std::uint64_t frames_lost = 0;  ///< by the scenario's loss probability or a rule of `caravan ctl radio`
  std::uint64_t frames_queue_full = 0;  ///< the receiver's limit for the step was reached
};

/// What the engine knows about a run, at its end or so far.
struct RunEnd {
  std::string digest;      ///< 16 hex digits
  bool disturbed = false;  ///< a process was lost or rejoined, or the run was steered
  bool interrupted = false;
  std::string failure;  ///< why it ended early; empty: it did not
  TimeSplit time_split;
  Refusals refusals;
  double wall_time_s = 0.0;            ///< from the first step to the last
  std::vector<std::string> strangers;  ///< participants whose samples were refused
};

enum class Outcome : std::uint8_t { kCompleted, kTimeOver, kInterrupted, kFailed };

/// Completed means that all items were delivered, or, if there are none to deliver, that the run lasted its
/// full time.
[[nodiscard]] Outcome outcome_of(const RunFacts& facts, const RunEnd& end, std::uint32_t items_delivered,
                                 Time sim_time);
/// 0, 1 or 130: the exit code of `caravan run`.
[[nodiscard]] int exit_code_of(Outcome outcome);

}  // namespace caravan::experiment
