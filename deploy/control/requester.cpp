// SPDX-License-Identifier: Apache-2.0
#include "deploy/control/requester.hpp"

#include <algorithm>

namespace caravan::deploy {
namespace msg = caravan_interfaces::msg;
using namespace std::chrono_literals;

namespace {

constexpr auto kRepeatAfter = 500ms;

bool is_for_the_radio(const msg::ControlRequest& request) {
  return request.action() >= msg::ControlRequest_Constants::RADIO_OVERRIDE;
}

ControlAnswer to_answer(const msg::ControlReply& reply) {
  ControlAnswer answer{ControlAnswer::Kind::kRefused, reply.step(), reply.reason()};
  if (reply.outcome() == msg::ControlReply_Constants::SCHEDULED)
    answer.kind = ControlAnswer::Kind::kScheduled;
  if (reply.outcome() == msg::ControlReply_Constants::DONE) answer.kind = ControlAnswer::Kind::kDone;
  return answer;
}

}  // namespace

void Requester::join(runtime::Bus& bus) {
  name_ = runtime::to_name(bus.identity());
  requests_ = bus.writer<msg::ControlRequestPubSubType>(idl::kControlRequest);
  bus.reader<msg::ControlReplyPubSubType>(
      idl::kControlReply, 0,
      [this](const msg::ControlReply& reply, const runtime::ParticipantId&) { on_reply(reply); });
}

void Requester::on_reply(const msg::ControlReply& reply) {
  const std::lock_guard lock{mutex_};
  if (reply.requester() != name_ || reply.id() != id_) return;
  answer_ = to_answer(reply);
  changed_.notify_all();
}

ControlAnswer Requester::ask(msg::ControlRequest request, std::chrono::milliseconds patience) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  const bool is_later = request.at_step() != 0 || is_for_the_radio(request);
  const auto is_final = [&] {
    return answer_ && (is_later || answer_->kind != ControlAnswer::Kind::kScheduled);
  };
  request.requester(name_);
  {
    const std::lock_guard lock{mutex_};
    request.id(++id_);
    answer_.reset();
  }
  for (;;) {
    requests_.write(request);  // without the lock: the answer may arrive on another thread meanwhile
    std::unique_lock lock{mutex_};
    const auto until = std::min(deadline, std::chrono::steady_clock::now() + kRepeatAfter);
    if (changed_.wait_until(lock, until, is_final)) return *answer_;
    if (std::chrono::steady_clock::now() < deadline) continue;
    if (answer_) return *answer_;
    const char* who = is_for_the_radio(request) ? "radio" : "world";
    return {ControlAnswer::Kind::kNone, 0, std::string{"no "} + who + " answered within the time"};
  }
}

}  // namespace caravan::deploy
