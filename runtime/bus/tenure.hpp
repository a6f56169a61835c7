// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "runtime/bus/participant.hpp"

namespace caravan::runtime {

/// Who holds a role, as one reader sees it: the first participant that claims it, until that has gone.
///
/// A participant that states the role takes it from one that does not (Claim::kWeak). Whoever else claims it
/// is refused. What the refused have sent last may be kept: once the holder has gone the first of them holds
/// the role, and what it has sent counts then, because it may be waiting for what follows from it and would
/// not send it again.
///
/// Not thread-safe.
class Tenure {
 public:
  using Later = std::function<void()>;

  /// @param kept  samples of each refused participant
  explicit Tenure(std::size_t kept = 1) : kept_{kept} {}

  enum class Standing : std::uint8_t {
    kHolds,   ///< as before
    kBegins,  ///< holds from now on
    kRefused
  };
  /// A sample of the role has come from `sender`.
  Standing claim(const Sender& sender);
  /// `later` does what the sample of a refused participant asks for. Without effect when there are too many
  /// of them.
  void keep(const Sender& sender, Later later);

  /// A participant has gone. @return true when it held the role, which nobody holds now
  bool release(const ParticipantId& gone);
  /// The next participant holds the role. @return what was kept of it, in order; empty: there is none
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
  std::vector<Refused> refused_;  // in the order in which they came
};

}  // namespace caravan::runtime
