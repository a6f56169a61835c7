// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/tenure.hpp"

#include <algorithm>
#include <utility>

namespace caravan::runtime {
namespace {

constexpr std::size_t kMostRefused = 8;  // participants whose samples are kept

bool is(const ParticipantId& one, const ParticipantId& other) { return one == other; }

}  // namespace

Tenure::Standing Tenure::claim(const Sender& sender) {
  if (holder_ && is(*holder_, sender)) return Standing::kHolds;
  if (sender.claim == Claim::kNone) return Standing::kRefused;
  if (holder_ && !(holder_->claim == Claim::kWeak && sender.claim == Claim::kFull)) return Standing::kRefused;
  holder_ = sender;
  std::erase_if(refused_, [&](const Refused& one) { return is(one.who, sender); });
  return Standing::kBegins;
}

Tenure::Refused* Tenure::refused(const ParticipantId& who) {
  const auto found =
      std::find_if(refused_.begin(), refused_.end(), [&](const Refused& one) { return is(one.who, who); });
  return found == refused_.end() ? nullptr : &*found;
}

void Tenure::keep(const Sender& sender, Later later) {
  Refused* known = refused(sender);
  if (known == nullptr) {
    if (refused_.size() >= kMostRefused) {
      const auto weak = std::find_if(refused_.begin(), refused_.end(),
                                     [](const Refused& one) { return one.who.claim == Claim::kWeak; });
      if (weak == refused_.end() || sender.claim == Claim::kWeak) return;
      refused_.erase(weak);
    }
    known = &refused_.emplace_back(Refused{sender, {}});
  }
  known->samples.push_back(std::move(later));
  if (known->samples.size() > kept_) known->samples.pop_front();
}

bool Tenure::release(const ParticipantId& gone) {
  std::erase_if(refused_, [&](const Refused& one) { return is(one.who, gone); });
  if (!holder_ || !is(*holder_, gone)) return false;
  holder_.reset();
  return true;
}

std::deque<Tenure::Later> Tenure::hand_over() {
  if (holder_ || refused_.empty()) return {};
  auto next = std::find_if(refused_.begin(), refused_.end(),
                           [](const Refused& one) { return one.who.claim == Claim::kFull; });
  if (next == refused_.end()) next = refused_.begin();
  holder_ = next->who;
  std::deque<Later> samples = std::move(next->samples);
  refused_.erase(next);
  return samples;
}

std::optional<ParticipantId> Tenure::holder() const {
  return holder_ ? std::optional<ParticipantId>{*holder_} : std::nullopt;
}

}  // namespace caravan::runtime
