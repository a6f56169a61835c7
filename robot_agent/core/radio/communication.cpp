// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/radio/communication.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "robot_agent/core/angle.hpp"
#include "robot_agent/core/radio/exchange/transfer.hpp"
#include "robot_agent/core/radio/frames/codec.hpp"
#include "robot_agent/core/radio/pairing/can_communicate.hpp"
#include "robot_agent/core/radio/pairing/pairing.hpp"
#include "robot_agent/core/sensing/neighbours.hpp"
#include "runtime/pure/assert.hpp"
#include "runtime/pure/overload.hpp"

namespace caravan::agent {

struct Communication::Impl {
  RobotId id;
  SharingSettings sharing;
  WaitSettings wait;
  Air air;
  Pairing pairing;
  State state = Free{};
  std::optional<Transfer> transfer;  // while InSession
  Contacts contacts;
  Time next_wait{0};
  std::optional<Whereabouts> told;  // as reported in the last WAIT
  Time told_at{0};
  std::optional<Time> robot_heard;  // when a robot was last received
  Channel listened;                 // the channel that this step's frames were received on
  std::vector<Refuse> refusals;     // of this step

  explicit Impl(const CommunicationSettings& settings)
      : id{settings.id},
        sharing{settings.sharing},
        wait{settings.wait},
        air{settings.air},
        pairing{id, sharing, wait.period} {
    CARAVAN_ASSERT(id.value != 0 && air.channel_count >= 2 && points_per_frame() >= 1);
  }

  [[nodiscard]] std::uint32_t points_per_frame() const {
    return std::min(sharing.points_per_frame, points_that_fit(air.mtu_bytes));
  }
  [[nodiscard]] static Mode mode(const AirInputs& inputs) {
    return inputs.own_path.size() >= 2 ? Mode::kTransport : Mode::kExplore;
  }
  [[nodiscard]] bool is_eligible(RobotId partner, Mode partners, const AirInputs& inputs) const {
    return can_communicate(sharing, contacts, mode(inputs), partner, partners, inputs.now);
  }
  [[nodiscard]] Channel channel_with(RobotId partner) const {
    return private_channel(id, partner, air.channel_count);
  }
  [[nodiscard]] bool is_for_me(RobotId from, RobotId to) const { return to == id && from != id; }
  [[nodiscard]] bool is_mine(RobotId from, std::uint16_t session) const {
    const auto* s = std::get_if<InSession>(&state);
    return s != nullptr && s->partner == from && s->session == session;
  }

  AirOutputs step(const AirInputs& inputs);
  void hear(const ReceivedFrame& frame, const AirInputs& inputs, AirOutputs& outputs);
  void hear_wait(const Wait& heard, const AirInputs& inputs, AirOutputs& outputs);
  void hear_fragment(const PathFragment& fragment, const AirInputs& inputs, AirOutputs& outputs);
  Send apply(const PairingEvent& event, const AirInputs& inputs, AirOutputs& outputs);
  void conclude(const Outcome& outcome, AirOutputs& outputs);
  void send_wait(const AirInputs& inputs, AirOutputs& outputs);
  void send_for_state(Send send, const AirInputs& inputs, AirOutputs& outputs);
  void send_rejections(Time now, AirOutputs& outputs);
  /// The robot is off the pose that its last WAIT predicts, and another robot may rely on that pose.
  [[nodiscard]] bool strays(const AirInputs& inputs) const;
  [[nodiscard]] Channel tuned() const;
  [[nodiscard]] bool is_robot_near(Time now) const;
};

AirOutputs Communication::Impl::step(const AirInputs& inputs) {
  AirOutputs outputs;
  outputs.frames.reserve(2);
  refusals.clear();
  for (const ReceivedFrame& frame : inputs.heard) hear(frame, inputs, outputs);
  const Send send = apply(Tick{}, inputs, outputs);
  send_wait(inputs, outputs);
  send_for_state(send, inputs, outputs);
  send_rejections(inputs.now, outputs);
  outputs.stand_still = stands_still(state);
  outputs.robot_near = is_robot_near(inputs.now);
  outputs.tuned = tuned();
  listened = outputs.tuned;
  return outputs;
}

void Communication::Impl::hear(const ReceivedFrame& frame, const AirInputs& inputs, AirOutputs& outputs) {
  const Decoded decoded = decode(frame.bytes);
  std::visit(pure::Overload{
                 [&](const Wait& heard) { hear_wait(heard, inputs, outputs); },
                 [&](const Accept& accept) {
                   if (!is_for_me(accept.from, accept.to)) return;
                   apply(AcceptHeard{accept, is_eligible(accept.from, accept.mode, inputs)}, inputs, outputs);
                 },
                 [&](const AcceptAck& ack) {
                   if (is_for_me(ack.from, ack.to)) apply(AcceptAckHeard{ack}, inputs, outputs);
                 },
                 [&](const Reject& reject) {
                   if (is_for_me(reject.from, reject.to)) apply(RejectHeard{reject}, inputs, outputs);
                 },
                 [&](const PathFragment& fragment) {
                   if (is_for_me(fragment.from, fragment.to)) hear_fragment(fragment, inputs, outputs);
                 },
                 [&](const End& end) {
                   if (!is_for_me(end.from, end.to)) return;
                   const bool crossed = is_mine(end.from, end.session) && transfer->holds_all();
                   apply(EndHeard{end.from, end.session, crossed}, inputs, outputs);
                 },
                 [&](DecodeError) { ++outputs.malformed; },
             },
             decoded);
}

void Communication::Impl::hear_wait(const Wait& heard, const AirInputs& inputs, AirOutputs& outputs) {
  if (heard.from == id) return;  // another robot uses our id
  robot_heard = inputs.now;
  outputs.robots.push_back(heard);
  apply(WaitHeard{heard, is_eligible(heard.from, heard.mode, inputs)}, inputs, outputs);
}

void Communication::Impl::hear_fragment(const PathFragment& fragment, const AirInputs& inputs,
                                        AirOutputs& outputs) {
  if (!is_mine(fragment.from, fragment.session)) return;
  robot_heard = inputs.now;
  transfer->absorb(fragment);
  const bool crossed = transfer->holds_all() && transfer->has_given();
  apply(FragmentHeard{fragment.from, fragment.session, crossed}, inputs, outputs);
}

/// Applies the decision of the state machine. A transfer exists exactly while a session is open.
Send Communication::Impl::apply(const PairingEvent& event, const AirInputs& inputs, AirOutputs& outputs) {
  const Decision decision = pairing.advance(state, event, inputs.now);
  if (decision.outcome) conclude(*decision.outcome, outputs);
  if (decision.refuse) refusals.push_back(*decision.refuse);
  state = decision.next;
  const bool is_open = std::holds_alternative<InSession>(state);
  if (is_open && !transfer) {
    transfer.emplace(inputs.own_path, wants_path(sharing.mode, mode(inputs)), points_per_frame());
  } else if (!is_open) {
    transfer.reset();
  }
  return decision.send;
}

void Communication::Impl::conclude(const Outcome& outcome, AirOutputs& outputs) {
  const Exchange& exchange = outcome.exchange;
  outputs.ended.push_back(exchange);
  const Time hold = exchange.completed ? Time{sharing.recontact_after} : outcome.hold;
  if (hold > Time{0}) contacts.avoid_until(exchange.partner, exchange.ended + hold);
  if (!exchange.completed) return;
  Path path = transfer->partners_path();
  if (!path.empty()) outputs.received = std::move(path);
}

bool Communication::Impl::strays(const AirInputs& inputs) const {
  if (!told || !inputs.whereabouts || !is_robot_near(inputs.now)) return false;
  if (inputs.now - told_at < wait.stray_pause) return false;
  const Neighbour believed = carried_on(id, *told, inputs.now - told_at);
  const Neighbour is = carried_on(id, *inputs.whereabouts, Time{0});
  return (believed.p_WB - is.p_WB).norm() > wait.stray_m ||
         std::abs(wrapped(believed.yaw_WB_rad - is.yaw_WB_rad)) > wait.stray_rad;
}

void Communication::Impl::send_wait(const AirInputs& inputs, AirOutputs& outputs) {
  if (inputs.now < next_wait && !strays(inputs)) return;
  next_wait = inputs.now + wait.period;
  const Presence presence = presence_in(state, inputs.now);
  const Wait frame{id, mode(inputs), presence.engagement, presence.partner, inputs.whereabouts};
  outputs.frames.push_back({kCommonChannel, encode(frame)});
  told = inputs.whereabouts;
  told_at = inputs.now;
}

void Communication::Impl::send_for_state(Send send, const AirInputs& inputs, AirOutputs& outputs) {
  const auto put = [&outputs](Channel channel, const Message& message) {
    outputs.frames.push_back({channel, encode(message)});
  };
  switch (send) {
    case Send::kNothing:
      return;
    case Send::kAccept: {
      const auto& s = std::get<Accepting>(state);
      return put(kCommonChannel, Accept{id, s.partner, s.session, mode(inputs)});
    }
    case Send::kAcceptAck: {
      const auto& s = std::get<InSession>(state);
      return put(kCommonChannel, AcceptAck{id, s.partner, s.session});
    }
    case Send::kFragment: {
      const auto& s = std::get<InSession>(state);
      PathFragment fragment = transfer->next();
      fragment.from = id;
      fragment.to = s.partner;
      fragment.session = s.session;
      return put(channel_with(s.partner), fragment);
    }
    case Send::kEnd: {
      const auto& s = std::get<Lingering>(state);
      return put(channel_with(s.partner), End{id, s.partner, s.session});
    }
  }
}

void Communication::Impl::send_rejections(Time now, AirOutputs& outputs) {
  for (const Refuse& refuse : refusals) {
    if (!contacts.may_reject(refuse.to, now, sharing.reject_period)) continue;
    const Channel channel = refuse.on_private_channel ? channel_with(refuse.to) : kCommonChannel;
    outputs.frames.push_back({channel, encode(Reject{id, refuse.to, refuse.session, refuse.refusal})});
  }
}

Channel Communication::Impl::tuned() const {
  return std::visit(pure::Overload{
                        [](const Free&) { return kCommonChannel; },
                        [](const Accepting&) { return kCommonChannel; },
                        [](const Awaiting&) { return kCommonChannel; },
                        [&](const InSession& s) { return channel_with(s.partner); },
                        [&](const Lingering& s) { return channel_with(s.partner); },
                    },
                    state);
}

/// Receivers get no WAIT while tuned away, nor between two WAITs.
bool Communication::Impl::is_robot_near(Time now) const {
  const Time remembered = listened == kCommonChannel ? Time{wait.period} : wait.remembered_away;
  return robot_heard && now - *robot_heard <= remembered;
}

Communication::Communication(const CommunicationSettings& settings)
    : impl_{std::make_unique<Impl>(settings)} {}
Communication::~Communication() = default;
Communication::Communication(Communication&&) noexcept = default;
Communication& Communication::operator=(Communication&&) noexcept = default;

AirOutputs Communication::step(const AirInputs& inputs) { return impl_->step(inputs); }

}  // namespace caravan::agent
