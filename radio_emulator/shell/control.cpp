// SPDX-License-Identifier: Apache-2.0
// Control requests to the running radio, and its replies.
#include <cmath>

#include "radio_emulator/shell/radio_shell.hpp"
#include "runtime/control/reply.hpp"

namespace caravan::radio {
namespace msg = caravan_interfaces::msg;
using pure::Outcome;

namespace {

namespace kind = msg::ControlRequest_Constants;

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

}  // namespace

void RadioShell::on_control(const msg::ControlRequest& request) {
  if (request.action() != kind::RADIO_OVERRIDE && request.action() != kind::RADIO_CLEAR) return;
  const std::lock_guard lock{mutex_};
  // Before the first truth, the request tells which session is the world's.
  if (!has_truth_ && request.session() > session_) begin_session(request.session());
  if (request.session() != session_) {
    reply(Outcome{request.requester(), request.id(), Outcome::Kind::kRefused, 0, "that session is over"});
    return;
  }
  const auto outcome =
      control_.ask({request.requester(), request.id(), request.at_step(), to_action(request)}, next_step_);
  if (outcome) reply(*outcome);
}

void RadioShell::reply(const Outcome& outcome) {
  runtime::log_outcome(outcome);
  msg::ControlReply reply = runtime::to_reply(outcome, session_);
  refused_writes_ += replies_.write(reply) ? 0U : 1U;
}

void RadioShell::reply(const std::vector<Outcome>& outcomes) {
  for (const Outcome& outcome : outcomes) reply(outcome);
}

}  // namespace caravan::radio
