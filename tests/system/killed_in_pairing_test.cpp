// SPDX-License-Identifier: Apache-2.0
// The agent of a robot is killed in each phase of pairing and exchange. The frame that was sent last
// identifies the phase.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <sstream>

#include "tests/system/support/faults.hpp"

namespace caravan::test {
namespace {

using deploy::Condition;
using deploy::Seen;

struct Phase {
  const char* name;
  const char* frame;            ///< sent in the newest step
  bool is_secondary;            ///< its sender has the lower id
  bool kills_receiver = false;  ///< kill the robot that stands and waits for it, not its sender

  friend std::ostream& operator<<(std::ostream& out, const Phase& one) { return out << one.name; }
};

struct Pair {
  std::uint32_t killed = 0;
  std::uint32_t partner = 0;
};

/// The robot to which `robot` has sent this frame: 2 for `ACCEPT_4-2`.
std::optional<std::uint32_t> receiver_of(const std::string& sent, const std::string& frame,
                                         std::uint32_t robot) {
  std::istringstream frames{sent};
  const std::string begin = frame + "_" + std::to_string(robot) + "-";
  for (std::string one; frames >> one;) {
    if (one.starts_with(begin)) return static_cast<std::uint32_t>(std::stoul(one.substr(begin.size())));
  }
  return std::nullopt;
}

class KilledInPairing : public Faults, public ::testing::WithParamInterface<Phase> {
 protected:
  static std::optional<Pair> in_phase(const Seen& now) {
    for (const auto& [robot, one] : now.robots) {
      if (!one.is_member || !one.sent) continue;
      const auto partner = receiver_of(*one.sent, GetParam().frame, robot);
      if (!partner || GetParam().is_secondary != (robot < *partner)) continue;
      if (!GetParam().kills_receiver) return Pair{robot, *partner};
      const auto receiver = now.robots.find(*partner);
      const bool stands = receiver != now.robots.end() && receiver->second.activity == "exchanging";
      if (stands && receiver->second.sent == "WAIT_" + std::to_string(*partner) + "_BUSY")
        return Pair{*partner, robot};
    }
    return std::nullopt;
  }
  /// Steps until any pair of robots is in the phase.
  Pair step_to_the_phase() {
    EXPECT_TRUE(does("pause"));
    EXPECT_TRUE(happens("it is paused", "state is paused"));
    EXPECT_TRUE(happens("everybody is overheard",
                        "sends 1 has WAIT and sends 2 has WAIT and sends 3 has WAIT and sends 4 has WAIT"));
    const Condition nobody{"nobody is in it", [](const Seen& now) { return !in_phase(now); }};
    const Condition somebody{"a robot sends it", [](const Seen& now) { return in_phase(now).has_value(); }};
    const deploy::ActionResult quiet = deployment().step_until(nobody, 1000);
    EXPECT_TRUE(quiet.good) << quiet.text;
    const deploy::ActionResult met = deployment().step_until(somebody, 3000);
    EXPECT_TRUE(met.good) << met.text;
    return in_phase(seen()).value_or(Pair{1, 2});
  }
};

TEST_P(KilledInPairing, IsNoticedFreesItsPartnerAndComesBackWithoutItsPath) {
  start_all_busy();
  const Pair pair = step_to_the_phase();
  const std::string name = "robot " + std::to_string(pair.killed);
  const std::string partner = std::to_string(pair.partner);
  ASSERT_TRUE(does("kill " + name));
  ASSERT_TRUE(does("resume"));
  EXPECT_TRUE(happens("its loss is noticed", "gone has \"" + name + "\" and members is 3"));
  EXPECT_TRUE(happens("its partner is free again",
                      "activity " + partner + " is not exchanging and member " + partner + " is yes"));
  EXPECT_TRUE(goes_on());

  // The new agent has kept nothing. The world is held while it starts, so that its first report stays
  // visible. Its robot is put where it does not see the destination; a few steps replace the frames of the
  // old place.
  ASSERT_TRUE(does("pause"));
  ASSERT_TRUE(does("teleport " + std::to_string(pair.killed) + " 4.5 4.5"));
  ASSERT_TRUE(does("step 8"));
  ASSERT_TRUE(happens("it is paused", "state is paused"));
  ASSERT_TRUE(does("start " + name));
  EXPECT_TRUE(happens("it starts from its initial state",
                      "gone lacks \"" + name + "\" and mode " + std::to_string(pair.killed) +
                          " is explore and path " + std::to_string(pair.killed) + " is none"));
  ASSERT_TRUE(does("resume"));
  expect_back_and_working(pair.killed);
  const std::uint32_t exchanges = seen().robots.at(pair.partner).exchanges;
  EXPECT_TRUE(
      happens("its partner exchanges again", "exchanges " + partner + " > " + std::to_string(exchanges)));
}

INSTANTIATE_TEST_SUITE_P(Phases, KilledInPairing,
                         ::testing::Values(Phase{"PrimaryThatHasAsked", "ACCEPT", false},
                                           Phase{"SecondaryThatWaitsForIt", "ACCEPT", false, true},
                                           Phase{"SecondaryThatHasAgreed", "ACCEPTACK", true},
                                           Phase{"PrimaryInTheSession", "PATH", false},
                                           Phase{"SecondaryInTheSession", "PATH", true},
                                           Phase{"PrimaryThatIsDone", "END", false},
                                           Phase{"SecondaryThatIsDone", "END", true}),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace caravan::test
