// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/radio/pairing/pairing.hpp"

#include <gtest/gtest.h>

namespace caravan::agent {
namespace {

using namespace std::chrono_literals;

constexpr RobotId kLow{3};
constexpr RobotId kMe{5};
constexpr RobotId kHigh{9};
constexpr RobotId kOther{7};
constexpr Time kNow = 1000s;
constexpr std::uint16_t kSession = 77;

WaitHeard wait(RobotId from, bool eligible, Engagement engagement = Engagement::kFree, RobotId partner = {}) {
  return {{from, Mode::kTransport, engagement, partner}, eligible};
}
AcceptHeard accept(RobotId from, bool eligible = true) { return {{from, kMe, kSession, {}}, eligible}; }
AcceptAckHeard ack(RobotId from, std::uint16_t session) { return {{from, kMe, session}}; }
RejectHeard reject(RobotId from, std::uint16_t session, Refusal refusal = Refusal::kDeclined) {
  return {{from, kMe, session, refusal}};
}

Accepting accepting() { return {kLow, kSession, kNow, kNow, kNow, 8}; }
Awaiting awaiting() { return {kHigh, kNow, kNow}; }
InSession in_session(bool confirmed) { return {kHigh, kSession, false, confirmed, kNow, kNow, kNow}; }
Lingering lingering() { return {kHigh, kSession, kNow + 500ms}; }

Decision decide(const State& state, const PairingEvent& event, Time now = kNow) {
  return Pairing{kMe, {}, Time{0}}.advance(state, event, now);
}
template <typename Expected>
::testing::AssertionResult is(const State& state) {
  if (std::holds_alternative<Expected>(state)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "state " << state.index();
}
/// Expects no change of state and no frame.
::testing::AssertionResult ignores(const State& state, const PairingEvent& event) {
  const Decision decision = decide(state, event);
  if (decision.next.index() == state.index() && decision.send == Send::kNothing && !decision.refuse &&
      !decision.outcome) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << "to state " << decision.next.index();
}

TEST(PairingFree, BeginsAsPrimaryWithALowerIdAndAsSecondaryWithAHigherOne) {  // P-30
  const Decision primary = decide(Free{}, wait(kLow, true));
  ASSERT_TRUE(is<Accepting>(primary.next));
  EXPECT_EQ(std::get<Accepting>(primary.next).partner, kLow);
  EXPECT_NE(std::get<Accepting>(primary.next).session, 0);
  const Decision secondary = decide(Free{}, wait(kHigh, true));
  ASSERT_TRUE(is<Awaiting>(secondary.next));
  EXPECT_EQ(std::get<Awaiting>(secondary.next).partner, kHigh);
}

TEST(PairingFree, DoesNotBeginWithOneThatIsNotEligibleOrBusyElsewhere) {  // P-30
  EXPECT_TRUE(ignores(Free{}, wait(kHigh, false)));
  EXPECT_TRUE(ignores(Free{}, wait(kHigh, true, Engagement::kAway)));
  EXPECT_TRUE(ignores(Free{}, wait(kHigh, true, Engagement::kNegotiating, kOther)));
  EXPECT_TRUE(ignores(Free{}, wait(kHigh, true, Engagement::kInSession, kOther)));
}

TEST(PairingFree, JoinsOneThatAlreadyWaitsForIt) {  // P-30
  EXPECT_TRUE(is<Accepting>(decide(Free{}, wait(kLow, true, Engagement::kNegotiating, kMe)).next));
  EXPECT_TRUE(is<Awaiting>(decide(Free{}, wait(kHigh, true, Engagement::kNegotiating, kMe)).next));
}

TEST(PairingFree, RejectsOneThatWaitsForItInVainWhereThatOneListens) {  // P-33
  const Decision negotiating = decide(Free{}, wait(kLow, false, Engagement::kNegotiating, kMe));
  ASSERT_TRUE(negotiating.refuse);
  EXPECT_EQ(negotiating.refuse->to, kLow);
  EXPECT_EQ(negotiating.refuse->session, 0);
  EXPECT_EQ(negotiating.refuse->refusal, Refusal::kDeclined);
  EXPECT_FALSE(negotiating.refuse->on_private_channel);
  const Decision in_session = decide(Free{}, wait(kLow, false, Engagement::kInSession, kMe));
  ASSERT_TRUE(in_session.refuse);
  EXPECT_TRUE(in_session.refuse->on_private_channel);
}

TEST(PairingFree, WhileRestingBeginsWithNobodyAndRejectsAsBusy) {  // P-32
  const Free resting{kNow + 1ns};
  EXPECT_TRUE(ignores(resting, wait(kHigh, true)));
  const Decision invited = decide(resting, wait(kHigh, true, Engagement::kNegotiating, kMe));
  EXPECT_TRUE(is<Free>(invited.next));
  ASSERT_TRUE(invited.refuse);
  EXPECT_EQ(invited.refuse->refusal, Refusal::kBusy);
  ASSERT_TRUE(decide(resting, accept(kHigh)).refuse);
  EXPECT_TRUE(is<Awaiting>(decide(Free{kNow}, wait(kHigh, true)).next));
}

TEST(PairingFree, OpensASessionOnAnAcceptOrRejectsIt) {  // P-31, P-33
  const Decision opened = decide(Free{}, accept(kHigh));
  ASSERT_TRUE(is<InSession>(opened.next));
  EXPECT_FALSE(std::get<InSession>(opened.next).confirmed);
  EXPECT_EQ(std::get<InSession>(opened.next).session, kSession);
  const Decision declined = decide(Free{}, accept(kHigh, false));
  EXPECT_TRUE(is<Free>(declined.next));
  ASSERT_TRUE(declined.refuse);
  EXPECT_EQ(declined.refuse->session, kSession);
  EXPECT_EQ(declined.refuse->refusal, Refusal::kDeclined);
}

TEST(PairingFree, IgnoresAnAcceptFromALowerIdAndEverythingStale) {  // P-36
  EXPECT_TRUE(ignores(Free{}, accept(kLow)));
  EXPECT_TRUE(ignores(Free{}, ack(kLow, kSession)));
  EXPECT_TRUE(ignores(Free{}, reject(kLow, kSession)));
  EXPECT_TRUE(ignores(Free{}, FragmentHeard{kLow, kSession, false}));
  EXPECT_TRUE(ignores(Free{}, EndHeard{kLow, kSession, false}));
  EXPECT_TRUE(ignores(Free{}, Tick{}));
}

TEST(PairingAccepting, SendsAcceptOnceAPeriodUpToTheNumberOfAttempts) {  // P-31
  State state = accepting();
  int sent = 0;
  for (Time now = kNow; is<Accepting>(state); now += 100ms) {
    ASSERT_LT(now, kNow + 20s);
    const PairingEvent alive = wait(kLow, true);
    state = decide(state, alive, now).next;
    const Decision decision = decide(state, Tick{}, now);
    if (decision.send == Send::kAccept) {
      EXPECT_EQ(now, kNow + sent * 1s);
      ++sent;
    }
    if (decision.outcome) {
      EXPECT_EQ(now, kNow + 8s);
      EXPECT_EQ(decision.outcome->hold, 30s);
      EXPECT_FALSE(decision.outcome->exchange.completed);
    }
    state = decision.next;
  }
  EXPECT_EQ(sent, 8);
}

TEST(PairingAccepting, OpensTheSessionOnItsPartnersAcknowledgementOnly) {  // P-31
  EXPECT_TRUE(ignores(accepting(), ack(kOther, kSession)));
  EXPECT_TRUE(ignores(accepting(), ack(kLow, kSession + 1)));
  const Decision opened = decide(accepting(), ack(kLow, kSession));
  ASSERT_TRUE(is<InSession>(opened.next));
  EXPECT_TRUE(std::get<InSession>(opened.next).confirmed);
  EXPECT_TRUE(std::get<InSession>(opened.next).primary);
}

TEST(PairingNegotiation, EndsOnItsPartnersRejection) {  // P-32
  for (const std::uint16_t session : {std::uint16_t{0}, kSession}) {
    const Decision declined = decide(accepting(), reject(kLow, session));
    ASSERT_TRUE(is<Free>(declined.next));
    EXPECT_EQ(std::get<Free>(declined.next).rests_until, kNow + 1s);
    EXPECT_EQ(declined.outcome->hold, 30s);
  }
  EXPECT_EQ(decide(accepting(), reject(kLow, 0, Refusal::kBusy)).outcome->hold, Time{0});
  EXPECT_TRUE(ignores(accepting(), reject(kLow, kSession + 1)));
  EXPECT_TRUE(ignores(accepting(), reject(kOther, 0)));
  EXPECT_TRUE(is<Free>(decide(awaiting(), reject(kHigh, 0)).next));
  EXPECT_TRUE(ignores(awaiting(), reject(kOther, 0)));
}

TEST(PairingNegotiation, EndsWhenThePartnerIsBusyWithAnother) {  // P-32
  const Decision taken = decide(awaiting(), wait(kHigh, true, Engagement::kNegotiating, kOther));
  EXPECT_TRUE(is<Free>(taken.next));
  EXPECT_EQ(taken.outcome->hold, Time{0});
  EXPECT_TRUE(is<Free>(decide(accepting(), wait(kLow, true, Engagement::kAway)).next));
  EXPECT_TRUE(is<Accepting>(decide(accepting(), wait(kLow, true, Engagement::kInSession, kMe)).next));
  EXPECT_TRUE(is<Awaiting>(decide(awaiting(), wait(kHigh, true)).next));
}

TEST(PairingNegotiation, EndsWhenThePartnerIsSilentOrTheSpanIsOver) {  // P-32
  for (const State& state : {State{accepting()}, State{awaiting()}}) {
    EXPECT_FALSE(is<Free>(decide(state, Tick{}, kNow + 2s - 1ns).next));
    EXPECT_TRUE(is<Free>(decide(state, Tick{}, kNow + 2s).next));
  }
  Awaiting long_ago = awaiting();
  long_ago.last_heard = kNow + 8s;
  EXPECT_TRUE(is<Free>(decide(long_ago, Tick{}, kNow + 8s).next));
}

TEST(PairingNegotiation, RejectsAllOthersThatWaitForIt) {  // P-33
  EXPECT_TRUE(ignores(awaiting(), wait(kOther, true)));
  const Decision waited_for = decide(awaiting(), wait(kOther, true, Engagement::kNegotiating, kMe));
  ASSERT_TRUE(waited_for.refuse);
  EXPECT_EQ(waited_for.refuse->refusal, Refusal::kBusy);
  const Decision accepted = decide(accepting(), accept(kOther));
  EXPECT_TRUE(is<Accepting>(accepted.next));
  ASSERT_TRUE(accepted.refuse);
  EXPECT_EQ(accepted.refuse->session, kSession);
  EXPECT_TRUE(ignores(accepting(), accept(kLow)));
}

TEST(PairingAwaiting, OpensASessionOnItsPartnersAccept) {  // P-31
  const Decision opened = decide(awaiting(), accept(kHigh), kNow + 1s);
  ASSERT_TRUE(is<InSession>(opened.next));
  EXPECT_EQ(std::get<InSession>(opened.next).began, kNow) << "standing since then";
  EXPECT_EQ(std::get<InSession>(opened.next).opened, kNow + 1s);
  ASSERT_TRUE(decide(awaiting(), accept(kOther)).refuse);
  EXPECT_TRUE(ignores(awaiting(), ack(kHigh, kSession)));
}

TEST(PairingInSession, RepeatsItsAcknowledgementUntilThePartnerIsHeard) {  // P-37
  EXPECT_EQ(decide(in_session(false), Tick{}).send, Send::kAcceptAck);
  const Decision heard = decide(in_session(false), FragmentHeard{kHigh, kSession, false});
  EXPECT_EQ(decide(heard.next, Tick{}).send, Send::kFragment);
}

TEST(PairingInSession, IgnoresOtherSessionsAndStrangers) {  // P-36
  EXPECT_TRUE(ignores(in_session(false), FragmentHeard{kHigh, kSession + 1, true}));
  EXPECT_TRUE(ignores(in_session(false), FragmentHeard{kOther, kSession, true}));
  EXPECT_TRUE(ignores(in_session(true), EndHeard{kHigh, kSession + 1, true}));
  EXPECT_TRUE(ignores(in_session(true), EndHeard{kHigh, kSession, false}));
  EXPECT_TRUE(ignores(in_session(true), reject(kHigh, kSession + 1)));
  EXPECT_TRUE(ignores(in_session(true), wait(kHigh, true)));
  EXPECT_TRUE(ignores(in_session(true), accept(kOther)));
  EXPECT_TRUE(ignores(in_session(true), ack(kOther, kSession)));
}

TEST(PairingInSession, CompletesWhenBothPathsHaveCrossedAndLingers) {  // P-38
  const Decision crossed = decide(in_session(true), FragmentHeard{kHigh, kSession, true}, kNow + 1s);
  ASSERT_TRUE(is<Lingering>(crossed.next));
  EXPECT_EQ(std::get<Lingering>(crossed.next).leaves, kNow + 1500ms);
  EXPECT_TRUE(crossed.outcome->exchange.completed);
  EXPECT_EQ(crossed.outcome->exchange.began, kNow);
  EXPECT_EQ(crossed.outcome->exchange.ended, kNow + 1s);
  const Decision ended = decide(in_session(true), EndHeard{kHigh, kSession, true});
  ASSERT_TRUE(is<Lingering>(ended.next));
  EXPECT_EQ(decide(ended.next, Tick{}).send, Send::kEnd) << "one END, since the partner has said END";
  EXPECT_TRUE(is<Free>(decide(ended.next, Tick{}, kNow + 32ms).next));
}

TEST(PairingInSession, FailsAtTheSessionTimerOnSilenceAndOnRejection) {  // P-32
  InSession session = in_session(true);
  EXPECT_TRUE(is<InSession>(decide(session, Tick{}, kNow + 2s - 1ns).next));
  EXPECT_TRUE(is<Free>(decide(session, Tick{}, kNow + 2s).next));
  session.last_heard = kNow + 10s;
  EXPECT_TRUE(is<InSession>(decide(session, Tick{}, kNow + 10s - 1ns).next));
  EXPECT_TRUE(is<Free>(decide(session, Tick{}, kNow + 10s).next));
  EXPECT_TRUE(is<Free>(decide(session, reject(kHigh, 0)).next));
}

TEST(PairingLingering, SendsEndUntilThePartnerSaysEndOrTheTimeIsOver) {  // P-38
  EXPECT_EQ(decide(lingering(), Tick{}, kNow + 500ms).send, Send::kEnd);
  EXPECT_TRUE(is<Free>(decide(lingering(), Tick{}, kNow + 501ms).next));
  EXPECT_TRUE(is<Free>(decide(lingering(), EndHeard{kHigh, kSession, false}).next));
  EXPECT_TRUE(ignores(lingering(), EndHeard{kHigh, kSession + 1, false}));
  EXPECT_TRUE(ignores(lingering(), wait(kLow, true)));
  EXPECT_TRUE(ignores(lingering(), accept(kHigh)));
  EXPECT_TRUE(ignores(lingering(), ack(kLow, kSession)));
  EXPECT_TRUE(ignores(lingering(), reject(kHigh, kSession)));
  EXPECT_TRUE(ignores(lingering(), FragmentHeard{kHigh, kSession, false}));
}

TEST(PairingPresence, TellsWhatTheStateIs) {  // P-3
  EXPECT_EQ(presence_in(Free{}, kNow).engagement, Engagement::kFree);
  EXPECT_EQ(presence_in(Free{kNow + 1ns}, kNow).engagement, Engagement::kAway);
  EXPECT_EQ(presence_in(accepting(), kNow).partner, kLow);
  EXPECT_EQ(presence_in(awaiting(), kNow).engagement, Engagement::kNegotiating);
  EXPECT_EQ(presence_in(in_session(true), kNow).engagement, Engagement::kInSession);
  EXPECT_EQ(presence_in(lingering(), kNow).engagement, Engagement::kAway);
}

TEST(PairingPresence, StandsStillWhileNegotiatingAndInSessionOnly) {  // P-5
  EXPECT_FALSE(stands_still(Free{}));
  EXPECT_TRUE(stands_still(accepting()));
  EXPECT_TRUE(stands_still(awaiting()));
  EXPECT_TRUE(stands_still(in_session(false)));
  EXPECT_FALSE(stands_still(lingering()));
}

}  // namespace
}  // namespace caravan::agent
