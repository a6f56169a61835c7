// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <tuple>

#include "experiment/metrics/observation.hpp"

namespace caravan::experiment {

/// Counts the exchanges of a run from the robots' reports.
///
/// Both robots report a session; it counts once, as completed if either reports it so. An attempt that ended
/// before a session number was known (0) counts once for each robot that gave up. A pair may use a number
/// again: reports of exchanges that began more than 60 s apart are two sessions.
class ExchangeAccount {
 public:
  void add(std::uint32_t robot, const Exchange& exchange);

  [[nodiscard]] std::uint64_t completed() const { return completed_; }
  [[nodiscard]] std::uint64_t failed() const { return failed_; }
  /// Mean over all reports of the time from stopping to resuming, failed attempts included; 0 without any.
  [[nodiscard]] double mean_duration_s() const;

 private:
  struct Session {
    Time began{0};
    bool completed = false;
  };
  using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;  // lower id, higher id, number
  std::map<Key, Session> sessions_;
  std::uint64_t completed_ = 0;
  std::uint64_t failed_ = 0;
  std::uint64_t reports_ = 0;
  double stood_ns_ = 0.0;  // exact up to 2^53, and does not overflow
};

}  // namespace caravan::experiment
