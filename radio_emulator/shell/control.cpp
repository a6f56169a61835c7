// SPDX-License-Identifier: Apache-2.0
// What is asked of the running radio, and its answers.
#include <spdlog/spdlog.h>

#include <cmath>

#include "radio_emulator/shell/radio_shell.hpp"

namespace caravan::radio {
namespace msg = caravan_interfaces::msg;
using pure::Outcome;

namespace {

namespace kind = msg::ControlRequest_Constants;
namespace result = msg::ControlReply_Constants;

RadioAction to_action(const msg::ControlRequest& request) {
  if (request.action() == kind::RADIO_CLEAR) return ClearRules{};
  LinkRule rule{.robots = request.robots(), .others = request.others(), .area = {}, .loss = {}};
  if (request.in_area()) {
    rule.area = Area{request.area_low_x_m(), request.area_low_y_m(), request.area_high_x_m(),
                     request.area_high_y_m()};
  }
  if (!std::isnan(request.loss_probability())) rule.loss = request.loss_probability();
  return AddRule{rule};
}

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

void RadioShell::on_control(const msg::ControlRequest& request) {
  if (request.action() != kind::RADIO_OVERRIDE && request.action() != kind::RADIO_CLEAR) return;
  const std::lock_guard lock{mutex_};
  if (!follow_session(request.session())) {
    reply(Outcome{request.requester(), request.id(), Outcome::Kind::kRefused, 0, "that session is over"});
    return;
  }
  const auto outcome =
      control_.ask({request.requester(), request.id(), request.at_step(), to_action(request)}, next_step_);
  if (outcome) reply(*outcome);
}

void RadioShell::reply(const Outcome& outcome) {
  if (outcome.kind != Outcome::Kind::kScheduled) {
    spdlog::info("control {} requester=\"{}\" id={} step={}{}{}",
                 outcome.kind == Outcome::Kind::kDone ? "done" : "refused", outcome.requester, outcome.id,
                 outcome.step, outcome.reason.empty() ? "" : ": ", outcome.reason);
  }
  msg::ControlReply sample;
  sample.requester(outcome.requester);
  sample.id(outcome.id);
  sample.session(session_);
  sample.outcome(to_wire(outcome.kind));
  sample.step(outcome.step);
  sample.reason(outcome.reason);
  refused_writes_ += replies_.write(sample) ? 0U : 1U;
}

void RadioShell::reply(const std::vector<Outcome>& outcomes) {
  for (const Outcome& outcome : outcomes) reply(outcome);
}

}  // namespace caravan::radio
