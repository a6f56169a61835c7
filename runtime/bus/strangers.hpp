// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "runtime/bus/participant.hpp"

namespace caravan::runtime {

/// Why a sample was refused.
enum class Refusal : std::uint8_t {
  kMalformed,  ///< its bytes are not of the type
  kTooLong,
  kNotItsRole,  ///< its writer states another role than the topic's writers have, or none
  kRoleIsHeld   ///< another participant holds the role
};

/// One participant whose samples were refused.
struct Stranger {
  std::string who;
  std::set<std::string> topics;  ///< the first few of them
  std::uint64_t refused = 0;     ///< number of refused samples
};

/// Participants whose samples were refused. Bounded: above a limit, all further ones share one entry.
///
/// Logs each of them once for each reason. Thread-safe.
class Strangers {
 public:
  void refuse(const ParticipantId& id, const Identity& identity, const std::string& topic, Refusal why);
  /// It holds the role now: it had joined before its predecessor was gone.
  void forgive(const ParticipantId& id);
  [[nodiscard]] std::vector<Stranger> all() const;

 private:
  struct Entry {
    Stranger stranger;
    std::set<Refusal> told;
  };
  mutable std::mutex mutex_;
  std::map<ParticipantId, Entry> entries_;
  Entry others_;
};

/// One line: who, on which topics, how many samples.
[[nodiscard]] std::string to_text(const Stranger& stranger);

}  // namespace caravan::runtime
