// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/radio/pairing/pairing.hpp"

#include "runtime/pure/overload.hpp"

namespace caravan::agent {
namespace {

// Unit of session numbers. Fixed by the protocol, not a setting: shorter than any rest.
constexpr Time kSessionSlot = std::chrono::milliseconds{100};

/// Differs between successive attempts of a pair, because a rest lies between them; never 0.
std::uint16_t session_number(Time now) {
  return static_cast<std::uint16_t>(1 + static_cast<std::uint64_t>(now / kSessionSlot) % 65535U);
}

template <typename Session>
bool belongs(const Session& state, RobotId from, std::uint16_t session) {
  return state.partner == from && state.session == session;
}
/// Session 0 in a REJECT matches any session.
bool refuses(const Reject& reject, std::uint16_t session) {
  return reject.session == 0 || reject.session == session;
}
Decision become(const State& next) { return {next, Send::kNothing, {}, {}}; }
Decision stay(const State& state) { return become(state); }
Decision stay_and_send(const State& state, Send send) { return {state, send, {}, {}}; }
Decision stay_and_refuse(const State& state, const Refuse& refuse) {
  return {state, Send::kNothing, refuse, {}};
}

}  // namespace

/// The cells of the table, for one robot at one time.
struct Pairing::Rules {
  const Pairing& pairing;
  Time now;

  [[nodiscard]] bool negotiated_enough(Time began, Time last_heard) const {
    const Time span = pairing.accept_period_ * static_cast<std::int64_t>(pairing.accept_attempts_);
    return now - began >= span || is_silent(last_heard);
  }
  [[nodiscard]] bool is_silent(Time last_heard) const { return now - last_heard >= pairing.silence_; }
  [[nodiscard]] bool waits_for_me(const Wait& wait) const { return wait.partner == pairing.id_; }

  [[nodiscard]] Time hold_after(Refusal refusal) const {
    return refusal == Refusal::kBusy ? Time{0} : pairing.hold_;
  }
  [[nodiscard]] Decision give_up(const Exchange& exchange, Time hold) const {
    return {Free{exchange.ended + pairing.rest_}, Send::kNothing, {}, Outcome{exchange, hold}};
  }
  [[nodiscard]] Decision failed(const Accepting& s, Time hold) const {
    return give_up({s.partner, s.session, true, false, s.began, now}, hold);
  }
  [[nodiscard]] Decision failed(const Awaiting& s, Time hold) const {
    return give_up({s.partner, 0, false, false, s.began, now}, hold);
  }
  [[nodiscard]] Decision failed(const InSession& s, Time hold) const {
    return give_up({s.partner, s.session, s.primary, false, s.began, now}, hold);
  }
  [[nodiscard]] Decision completed(const InSession& s, Time leaves) const {
    const Exchange exchange{s.partner, s.session, s.primary, true, s.began, now};
    return {Lingering{s.partner, s.session, leaves}, Send::kNothing, {}, Outcome{exchange, Time{0}}};
  }
  [[nodiscard]] Decision begin(RobotId partner) const {
    if (partner > pairing.id_) return become(Awaiting{partner, now, now});
    return become(Accepting{partner, session_number(now), now, now, now, pairing.accept_attempts_});
  }
  [[nodiscard]] Decision open(const Accept& accept, Time began) const {
    return become(InSession{accept.from, accept.session, false, false, began, now, now});
  }
  [[nodiscard]] static Refuse answer(const Wait& wait, Refusal refusal) {
    return {wait.from, 0, refusal, wait.engagement == Engagement::kInSession};
  }
  [[nodiscard]] static Refuse answer(const Accept& accept, Refusal refusal) {
    return {accept.from, accept.session, refusal, false};
  }

  [[nodiscard]] Decision free_hears(const Free& s, const WaitHeard& e) const {
    const bool waits_for_accept = waits_for_me(e.wait) && e.wait.engagement == Engagement::kNegotiating;
    const bool is_available = e.wait.engagement == Engagement::kFree || waits_for_accept;
    if (is_available && e.eligible && now >= s.rests_until) return begin(e.wait.from);
    if (!waits_for_me(e.wait)) return stay(s);
    return stay_and_refuse(s, answer(e.wait, e.eligible ? Refusal::kBusy : Refusal::kDeclined));
  }
  [[nodiscard]] Decision free_hears(const Free& s, const AcceptHeard& e) const {
    if (e.accept.from < pairing.id_) return stay(s);  // a primary has the higher id
    if (e.eligible && now >= s.rests_until) return open(e.accept, now);
    return stay_and_refuse(s, answer(e.accept, e.eligible ? Refusal::kBusy : Refusal::kDeclined));
  }

  /// Accepting or Awaiting.
  template <typename Negotiating>
  [[nodiscard]] Decision negotiating_hears(Negotiating s, const WaitHeard& e) const {
    if (e.wait.from != s.partner) {
      return waits_for_me(e.wait) ? stay_and_refuse(s, answer(e.wait, Refusal::kBusy)) : stay(s);
    }
    s.last_heard = now;
    const bool is_busy = e.wait.engagement != Engagement::kFree && !waits_for_me(e.wait);
    return is_busy ? failed(s, Time{0}) : stay(s);
  }
  template <typename Negotiating>
  [[nodiscard]] Decision refuse_as_busy(const Negotiating& s, const Accept& accept) const {
    if (accept.from == s.partner || accept.from < pairing.id_) return stay(s);
    return stay_and_refuse(s, answer(accept, Refusal::kBusy));
  }
  [[nodiscard]] Decision accepting_hears(const Accepting& s, const AcceptAckHeard& e) const {
    if (!belongs(s, e.ack.from, e.ack.session)) return stay(s);
    return become(InSession{s.partner, s.session, true, true, s.began, now, now});
  }
  [[nodiscard]] Decision accepting_hears(const Accepting& s, const RejectHeard& e) const {
    if (e.reject.from != s.partner || !refuses(e.reject, s.session)) return stay(s);
    return failed(s, hold_after(e.reject.refusal));
  }
  [[nodiscard]] Decision accepting_ticks(Accepting s) const {
    if (negotiated_enough(s.began, s.last_heard)) return failed(s, pairing.hold_);
    if (now < s.next_accept || s.accepts_left == 0) return stay(s);
    s.next_accept += pairing.accept_period_;
    --s.accepts_left;
    return stay_and_send(s, Send::kAccept);
  }
  [[nodiscard]] Decision awaiting_hears(const Awaiting& s, const AcceptHeard& e) const {
    return e.accept.from == s.partner ? open(e.accept, s.began) : refuse_as_busy(s, e.accept);
  }
  [[nodiscard]] Decision awaiting_hears(const Awaiting& s, const RejectHeard& e) const {
    return e.reject.from == s.partner ? failed(s, hold_after(e.reject.refusal)) : stay(s);
  }
  [[nodiscard]] Decision awaiting_ticks(const Awaiting& s) const {
    return negotiated_enough(s.began, s.last_heard) ? failed(s, pairing.hold_) : stay(s);
  }

  [[nodiscard]] Decision in_session_hears(const InSession& s, const RejectHeard& e) const {
    if (e.reject.from != s.partner || !refuses(e.reject, s.session)) return stay(s);
    return failed(s, hold_after(e.reject.refusal));
  }
  /// @param linger  how long END is repeated when the exchange is complete
  template <typename Heard>
  [[nodiscard]] Decision in_session_hears(InSession s, const Heard& e, Time linger) const {
    if (!belongs(s, e.from, e.session)) return stay(s);
    if (e.crossed) return completed(s, now + linger);
    s.last_heard = now;
    s.confirmed = true;
    return stay(s);
  }
  [[nodiscard]] Decision in_session_ticks(const InSession& s) const {
    if (now - s.opened >= pairing.session_timer_ || is_silent(s.last_heard)) return failed(s, pairing.hold_);
    return stay_and_send(s, s.confirmed ? Send::kFragment : Send::kAcceptAck);
  }

  [[nodiscard]] Decision lingering_hears(const Lingering& s, const EndHeard& e) const {
    return belongs(s, e.from, e.session) ? become(Free{now}) : stay(s);
  }
  [[nodiscard]] Decision lingering_ticks(const Lingering& s) const {
    return now > s.leaves ? become(Free{now}) : stay_and_send(s, Send::kEnd);
  }
};

Pairing::Pairing(RobotId id, const SharingSettings& sharing, Time wait_period)
    : id_{id},
      accept_period_{sharing.accept_period},
      accept_attempts_{sharing.accept_attempts},
      session_timer_{sharing.session_timer},
      silence_{sharing.silence + 2 * wait_period},
      linger_{sharing.linger},
      rest_{sharing.rest},
      hold_{sharing.hold} {}

Decision Pairing::advance(const State& state, const PairingEvent& event, Time now) const {
  const Rules rules{*this, now};
  return std::visit(
      pure::Overload{
          [&](const Free& s, const WaitHeard& e) { return rules.free_hears(s, e); },
          [&](const Free& s, const AcceptHeard& e) { return rules.free_hears(s, e); },
          [&](const Free& s, const AcceptAckHeard&) { return stay(s); },
          [&](const Free& s, const RejectHeard&) { return stay(s); },
          [&](const Free& s, const FragmentHeard&) { return stay(s); },
          [&](const Free& s, const EndHeard&) { return stay(s); },
          [&](const Free& s, const Tick&) { return stay(s); },

          [&](const Accepting& s, const WaitHeard& e) { return rules.negotiating_hears(s, e); },
          [&](const Accepting& s, const AcceptHeard& e) { return rules.refuse_as_busy(s, e.accept); },
          [&](const Accepting& s, const AcceptAckHeard& e) { return rules.accepting_hears(s, e); },
          [&](const Accepting& s, const RejectHeard& e) { return rules.accepting_hears(s, e); },
          [&](const Accepting& s, const FragmentHeard&) { return stay(s); },
          [&](const Accepting& s, const EndHeard&) { return stay(s); },
          [&](const Accepting& s, const Tick&) { return rules.accepting_ticks(s); },

          [&](const Awaiting& s, const WaitHeard& e) { return rules.negotiating_hears(s, e); },
          [&](const Awaiting& s, const AcceptHeard& e) { return rules.awaiting_hears(s, e); },
          [&](const Awaiting& s, const AcceptAckHeard&) { return stay(s); },
          [&](const Awaiting& s, const RejectHeard& e) { return rules.awaiting_hears(s, e); },
          [&](const Awaiting& s, const FragmentHeard&) { return stay(s); },
          [&](const Awaiting& s, const EndHeard&) { return stay(s); },
          [&](const Awaiting& s, const Tick&) { return rules.awaiting_ticks(s); },

          [&](const InSession& s, const WaitHeard&) { return stay(s); },
          [&](const InSession& s, const AcceptHeard&) { return stay(s); },
          [&](const InSession& s, const AcceptAckHeard&) { return stay(s); },
          [&](const InSession& s, const RejectHeard& e) { return rules.in_session_hears(s, e); },
          [&](const InSession& s, const FragmentHeard& e) { return rules.in_session_hears(s, e, linger_); },
          [&](const InSession& s, const EndHeard& e) { return rules.in_session_hears(s, e, Time{0}); },
          [&](const InSession& s, const Tick&) { return rules.in_session_ticks(s); },

          [&](const Lingering& s, const WaitHeard&) { return stay(s); },
          [&](const Lingering& s, const AcceptHeard&) { return stay(s); },
          [&](const Lingering& s, const AcceptAckHeard&) { return stay(s); },
          [&](const Lingering& s, const RejectHeard&) { return stay(s); },
          [&](const Lingering& s, const FragmentHeard&) { return stay(s); },
          [&](const Lingering& s, const EndHeard& e) { return rules.lingering_hears(s, e); },
          [&](const Lingering& s, const Tick&) { return rules.lingering_ticks(s); },
      },
      state, event);
}

Presence presence_in(const State& state, Time now) {
  return std::visit(pure::Overload{
                        [&](const Free& s) {
                          return Presence{now < s.rests_until ? Engagement::kAway : Engagement::kFree, {}};
                        },
                        [](const Accepting& s) {
                          return Presence{Engagement::kNegotiating, s.partner};
                        },
                        [](const Awaiting& s) {
                          return Presence{Engagement::kNegotiating, s.partner};
                        },
                        [](const InSession& s) {
                          return Presence{Engagement::kInSession, s.partner};
                        },
                        [](const Lingering&) {
                          return Presence{Engagement::kAway, {}};
                        },
                    },
                    state);
}

bool stands_still(const State& state) {
  return !std::holds_alternative<Free>(state) && !std::holds_alternative<Lingering>(state);
}

}  // namespace caravan::agent
