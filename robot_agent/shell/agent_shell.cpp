// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/shell/agent_shell.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "runtime/config/start_error.hpp"
#include "runtime/process/run_process.hpp"

namespace caravan::agent {
namespace msg = caravan_interfaces::msg;
using runtime::Discovery;
using runtime::Sender;
using runtime::Tenure;
using namespace std::chrono_literals;

namespace {

constexpr auto kWatchPeriod = 500ms;  // bounds the delay in noticing the radio deadline
constexpr auto kLongStep = 2s;        // of a step of a controller
constexpr auto kSayWaitingAfter = 1s;
constexpr auto kSayWaitingAgain = 60s;

}  // namespace

AgentShell::AgentShell(const Controllers& controllers, const std::vector<Config>& configs,
                       const runtime::BusConfig& bus, runtime::Loop& loop)
    : loop_{loop},
      lease_s_{bus.lease_s},
      began_{std::chrono::steady_clock::now()},
      controllers_{controllers},
      bus_{bus, [this](const Discovery& news) {
             if (news.kind != Discovery::Kind::kJoined) mailbox_.post(news);
           }} {
  clash_.emplace(bus_.id(), bus_.identity(), bus.lease_s, began_);
  for (const Config& config : configs) {
    robot_of_topic_[idl::name_for(idl::kCommand, config.id.value)] = config.id.value;
    agents_.emplace_back(controllers_, config, bus_, calls_);
  }
  // Not under the lock: making a reader waits for locks of DDS, whose holders may wait for ours in a
  // callback.
  for (Hosted& one : agents_) make_readers(one);
  watch_.emplace(calls_, [this](std::uint64_t, runtime::CallWatch::Reason reason) { end_process(reason); });
}

AgentShell::~AgentShell() { bus_.close(); }

void AgentShell::make_readers(Hosted& one) {
  bus_.reader<msg::RadioReceivePubSubType>(
      idl::kRadioReceive, one.agent.robot(),
      [this, &one](const msg::RadioReceive& sample, const Sender& sender) { hear(one, sample, sender); });
  bus_.reader<msg::SensorFramePubSubType>(
      idl::kSensors, one.agent.robot(),
      [this, &one](const msg::SensorFrame& frame, const Sender& sender) { sense(one, frame, sender); });
}

void AgentShell::hear(Hosted& one, const msg::RadioReceive& sample, const Sender& sender) {
  const std::lock_guard lock{mutex_};
  if (one.radio.claim(sender) != Tenure::Standing::kRefused) {
    one.agent.hear(sample, !clash_->must_be_silent());
    if (!one.agent.fault().empty()) loop_.notify();
    return;
  }
  bus_.refuse(sender, idl::kRadioReceive, one.agent.robot());
  one.radio.keep(sender, [this, &one, sample] { one.agent.hear(sample, !clash_->must_be_silent()); });
}

void AgentShell::sense(Hosted& one, const msg::SensorFrame& frame, const Sender& sender) {
  const std::lock_guard lock{mutex_};
  const Tenure::Standing standing = one.provider.claim(sender);
  if (standing == Tenure::Standing::kRefused) {
    bus_.refuse(sender, idl::kSensors, one.agent.robot());
    one.provider.keep(sender, [this, &one, frame] {
      one.agent.meet_provider();
      one.agent.sense(frame, !clash_->must_be_silent());
    });
    return;
  }
  if (standing == Tenure::Standing::kBegins) one.agent.meet_provider();
  one.agent.sense(frame, !clash_->must_be_silent());
  if (!one.agent.fault().empty()) loop_.notify();
}

void AgentShell::read_mailbox(Wall now) {
  for (const Discovery& news : mailbox_.take()) {
    if (news.kind == Discovery::Kind::kWriterFound) {
      meet(news, now);
    } else if (news.kind != Discovery::Kind::kReaderFound) {
      forget(news);
    }
  }
}

void AgentShell::meet(const Discovery& writer, Wall now) {
  const auto ours = robot_of_topic_.find(writer.topic);
  if (ours == robot_of_topic_.end() || claim_of(idl::kCommand, writer.identity) == runtime::Claim::kNone)
    return;
  const std::uint32_t robot = ours->second;
  const auto one = std::find_if(agents_.begin(), agents_.end(),
                                [robot](const Hosted& hosted) { return hosted.agent.robot() == robot; });
  const bool has_answered = one->agent.has_world() && !clash_->must_be_silent();
  if (clash_->found(robot, writer.participant, writer.identity, has_answered, now)) return;
  spdlog::warn("robot {} has another writer of its commands: {}; the one whose command came first drives it",
               robot, to_text(writer.participant, writer.identity));
}

void AgentShell::forget(const Discovery& gone) {
  const auto concerns = [&gone](const idl::Topic& topic, std::uint32_t robot) {
    return gone.kind == Discovery::Kind::kGone || gone.topic == idl::name_for(topic, robot);
  };
  if (gone.kind == Discovery::Kind::kGone || robot_of_topic_.contains(gone.topic))
    clash_->vanished(gone.participant);
  bool was_provider = false;
  for (Hosted& one : agents_) {
    if (concerns(idl::kSensors, one.agent.robot()) && one.provider.release(gone.participant)) {
      was_provider = true;
      hand_over(one.provider);
    }
    if (concerns(idl::kRadioReceive, one.agent.robot()) && one.radio.release(gone.participant))
      hand_over(one.radio);
  }
  if (was_provider) spdlog::info("{} is gone: waiting for another one", gone.identity.role);
}

void AgentShell::hand_over(Tenure& tenure) {
  for (const Tenure::Later& take : tenure.hand_over()) take();
  if (const auto holder = tenure.holder()) bus_.forgive(*holder);
}

void AgentShell::settle_clash(Wall now) {
  const auto holder = clash_->lost_to(now);
  if (!holder) return;
  for (Hosted& one : agents_) {
    if (one.agent.robot() != holder->robot) one.agent.halt();
  }
  throw runtime::StartError{"robot " + std::to_string(holder->robot) + " is already run by pid " +
                            std::to_string(holder->identity.pid) + " on host " + holder->identity.host +
                            ": stop that one or choose another number"};
}

void AgentShell::watch(Wall now) {
  read_mailbox(now);
  settle_clash(now);
  const bool refused = std::any_of(agents_.begin(), agents_.end(),
                                   [](const Hosted& one) { return one.agent.refused_writes() > 0; });
  if (refused && !told_refused_writes_) {
    spdlog::error("DDS refused a sample: the world or an observer may be waiting for it");
    told_refused_writes_ = true;
  }
  if (clash_->must_be_silent()) return;
  for (Hosted& one : agents_) one.agent.catch_up(now);
  say_who_waits(now);
}

const HostedAgent* AgentShell::first_without_world() const {
  const auto found = std::find_if_not(agents_.begin(), agents_.end(),
                                      [](const Hosted& one) { return one.agent.has_world(); });
  return found == agents_.end() ? nullptr : &found->agent;
}

void AgentShell::say_who_waits(Wall now) {
  const HostedAgent* waiting = first_without_world();
  if (waiting == nullptr || now - began_ < kSayWaitingAfter) return;
  if (said_waiting_ && now - *said_waiting_ < kSayWaitingAgain) return;
  spdlog::info("waiting for the world: nothing on {} yet", idl::name_for(idl::kSensors, waiting->robot()));
  said_waiting_ = now;
}

AgentShell::Wall AgentShell::next_deadline(Wall now) const {
  const bool idle = said_waiting_ && first_without_world() == &agents_.front().agent;
  Wall deadline = now + (idle ? Wall::duration{kSayWaitingAgain} : Wall::duration{kWatchPeriod});
  if (const auto clash = clash_->deadline()) deadline = std::min(deadline, *clash);
  return deadline;
}

const HostedAgent* AgentShell::called_agent() const {
  const auto found = std::find_if(agents_.begin(), agents_.end(),
                                  [](const Hosted& one) { return one.agent.called() != nullptr; });
  return found == agents_.end() ? nullptr : &found->agent;
}

void AgentShell::end_process(runtime::CallWatch::Reason reason) const {
  const bool is_stop = reason == runtime::CallWatch::Reason::kStop;
  const HostedAgent* agent = called_agent();
  spdlog::critical("controller {}, robot {}{} {}", controllers_.name(), agent == nullptr ? 0 : agent->robot(),
                   agent == nullptr ? ": a call" : agent->call_in_words(), to_text(reason));
  spdlog::shutdown();
  std::_Exit(is_stop ? runtime::kDone : runtime::kFailed);  // a thread cannot be stopped otherwise
}

std::unique_lock<std::timed_mutex> AgentShell::lock_or_end(bool is_stopping) {
  std::unique_lock lock{mutex_, kWatchPeriod};
  // Counts periods instead of reading a clock: a process stopped by a debugger, for instance, has lost no
  // time.
  for (auto waited = kWatchPeriod; !lock.owns_lock(); waited += kWatchPeriod) {
    const HostedAgent* agent = called_agent();
    if (agent != nullptr && is_stopping) end_process(runtime::CallWatch::Reason::kStop);
    if (agent != nullptr && waited == kLongStep) {
      spdlog::warn("controller {}, robot {}{} has not returned for {} s", controllers_.name(), agent->robot(),
                   agent->call_in_words(), kLongStep / 1s);
    }
    (void)lock.try_lock_for(kWatchPeriod);
  }
  return lock;
}

bool AgentShell::has_failed() const {
  return std::any_of(agents_.begin(), agents_.end(),
                     [](const Hosted& one) { return !one.agent.fault().empty(); });
}

void AgentShell::halt_all() {
  for (Hosted& one : agents_) {
    if (!one.agent.fault().empty()) spdlog::error("{}", one.agent.fault());
    one.agent.halt();
  }
}

int AgentShell::run() {
  for (;;) {
    Wall deadline;
    {
      const auto lock = lock_or_end(false);
      if (has_failed()) {
        halt_all();
        return runtime::kFailed;
      }
      const Wall now = std::chrono::steady_clock::now();
      watch(now);
      deadline = next_deadline(now);
    }
    if (loop_.wait(deadline) != runtime::Loop::Woken::kStop) {
      if (loop_.was_suspended_for(lease_s_)) throw runtime::BeginAnew{"suspended for longer than the lease"};
      continue;
    }
    const auto lock = lock_or_end(true);
    if (!clash_->must_be_silent()) halt_all();
    return runtime::kDone;
  }
}

}  // namespace caravan::agent
