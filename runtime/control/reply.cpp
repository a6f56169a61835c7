// SPDX-License-Identifier: Apache-2.0
#include "runtime/control/reply.hpp"

#include <spdlog/spdlog.h>

namespace caravan::runtime {
namespace msg = caravan_interfaces::msg;
using pure::Outcome;

namespace {

namespace result = msg::ControlReply_Constants;

std::uint8_t to_wire(Outcome::Kind outcome) {
  switch (outcome) {
    case Outcome::Kind::kRefused:
      return result::REFUSED;
    case Outcome::Kind::kScheduled:
      return result::SCHEDULED;
    case Outcome::Kind::kDone:
      return result::DONE;
  }
  return result::REFUSED;
}

}  // namespace

msg::ControlReply to_reply(const Outcome& outcome, std::uint64_t session) {
  msg::ControlReply reply;
  reply.requester(outcome.requester);
  reply.id(outcome.id);
  reply.session(session);
  reply.outcome(to_wire(outcome.kind));
  reply.step(outcome.step);
  reply.reason(outcome.reason);
  return reply;
}

void log_outcome(const Outcome& outcome) {
  if (outcome.kind == Outcome::Kind::kScheduled) return;
  spdlog::info("control {} requester=\"{}\" id={} step={}{}{}",
               outcome.kind == Outcome::Kind::kDone ? "done" : "refused", outcome.requester, outcome.id,
               outcome.step, outcome.reason.empty() ? "" : ": ", outcome.reason);
}

}  // namespace caravan::runtime
