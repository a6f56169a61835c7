// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "runtime/bus/participant.hpp"

namespace caravan::runtime {

/// The holder of a role, as seen by one reader: the first participant that claims it, until that has gone.
///
/// A participant that states the role takes it from one that does not (Claim::kWeak). All other claims are
/// refused. The latest samples of refused participants may be kept: when the holder has gone, the first
/// refused participant becomes the holder, and its kept samples count then, because it may be waiting for
/// their effect and would not send them again.
///
/// Not thread-safe.
class Tenure {
 public:
  using Later = std::function<void()>;

  /// @param kept  number of samples kept of each refused participant
  explicit Tenure(std::size_t kept = 1) : kept_{kept} {}

  enum class Standing : std::uint8_t {
    kHolds,   ///< already held the role
    kBegins,  ///< becomes the holder with this sample
    kRefused
  };
  /// Handles the arrival of a sample of the role from `sender`.
  Standing claim(const Sender& sender);
  /// Keeps `later`, which applies the sample of a refused participant. Has no effect when there are too many
  /// refused participants.
  void keep(const Sender& sender, Later later);

  /// A participant has gone. @return true when it held the role, which then has no holder
  bool release(const ParticipantId& gone);
  /// The next participant becomes the holder. @return its kept samples, in order; empty: there is no next one
  [[nodiscard]] std::deque<Later> hand_over();

  [[nodiscard]] std::optional<ParticipantId> holder() const;

 private:
  struct Refused {
    Sender who;
    std::deque<Later> samples;
  };
  [[nodiscard]] Refused* refused(const ParticipantId& who);

  std::size_t kept_;
  std::optional<Sender> holder_;
  std::vector<Refused> refused_;  // in order of arrival
};

}  // namespace caravan::runtime
