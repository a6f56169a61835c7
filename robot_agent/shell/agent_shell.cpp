// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/shell/agent_shell.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>

#include "runtime/config/start_error.hpp"
#include "runtime/process/run_process.hpp"

namespace caravan::agent {
namespace msg = caravan_interfaces::msg;
using runtime::Discovery;
using runtime::ParticipantId;
using namespace std::chrono_literals;

namespace {

constexpr auto kWatchPeriod = 500ms;  // how late the radio deadline may be noticed
constexpr auto kSayWaitingAfter = 1s;
constexpr auto kSayWaitingAgain = 60s;

}  // namespace

AgentShell::AgentShell(const std::vector<Config>& configs, const runtime::BusConfig& bus, runtime::Loop& loop)
    : loop_{loop},
      lease_s_{bus.lease_s},
      began_{std::chrono::steady_clock::now()},
      bus_{bus, [this](const Discovery& news) {
             if (news.kind != Discovery::Kind::kJoined) mailbox_.post(news);
           }} {
  clash_.emplace(bus_.id(), bus_.identity(),
                 std::chrono::nanoseconds{static_cast<std::int64_t>((bus.lease_s + 0.5) * 1e9)});
  for (const Config& config : configs) {
    robot_of_topic_[idl::name_for(idl::kCommand, config.id.value)] = config.id.value;
    agents_.emplace_back(config, bus_);
  }
  // Not under the lock: making a reader waits for DDS's own locks, whose holders may be waiting for ours in a
  // callback.
  for (HostedAgent& agent : agents_) make_readers(agent);
}

AgentShell::~AgentShell() { bus_.close(); }

void AgentShell::make_readers(HostedAgent& agent) {
  bus_.reader<msg::RadioReceivePubSubType>(
      idl::kRadioReceive, agent.robot(),
      [this, &agent](const msg::RadioReceive& sample, const ParticipantId&) {
        const std::lock_guard lock{mutex_};
        agent.hear(sample, !clash_->must_be_silent());
      });
  bus_.reader<msg::SensorFramePubSubType>(
      idl::kSensors, agent.robot(),
      [this, &agent](const msg::SensorFrame& frame, const ParticipantId& sender) {
        const std::lock_guard lock{mutex_};
        source_ = sender;
        agent.sense(frame, !clash_->must_be_silent());
      });
}

void AgentShell::read_mailbox(Wall now) {
  for (const Discovery& one : mailbox_.take()) {
    if (one.kind == Discovery::Kind::kGone) {
      clash_->vanished(one.participant);
      if (source_ == one.participant) spdlog::info("{} is gone: waiting for another one", one.identity.role);
    }
    if (one.kind != Discovery::Kind::kWriterFound) continue;
    if (const auto ours = robot_of_topic_.find(one.topic); ours != robot_of_topic_.end()) {
      clash_->found(ours->second, one.participant, one.identity, now);
    }
  }
}

void AgentShell::settle_clash(Wall now) {
  const auto deadline = clash_->deadline();
  if (!deadline || now < *deadline) return;
  const Clash::Holder& holder = clash_->holder();
  for (HostedAgent& agent : agents_) {
    if (agent.robot() != holder.robot) agent.halt();
  }
  throw runtime::StartError{"robot " + std::to_string(holder.robot) + " is already run by pid " +
                            std::to_string(holder.identity.pid) + " on host " + holder.identity.host +
                            ": stop that one or choose another number"};
}

void AgentShell::watch(Wall now) {
  read_mailbox(now);
  settle_clash(now);
  const bool refused = std::any_of(agents_.begin(), agents_.end(),
                                   [](const HostedAgent& agent) { return agent.refused_writes() > 0; });
  if (refused && !told_refused_writes_) {
    spdlog::error("DDS refused a sample: the world or an observer may be waiting for it");
    told_refused_writes_ = true;
  }
  if (clash_->must_be_silent()) return;
  for (HostedAgent& agent : agents_) agent.catch_up(now);
  say_who_waits(now);
}

const HostedAgent* AgentShell::first_without_world() const {
  const auto found = std::find_if_not(agents_.begin(), agents_.end(),
                                      [](const HostedAgent& agent) { return agent.has_world(); });
  return found == agents_.end() ? nullptr : &*found;
}

void AgentShell::say_who_waits(Wall now) {
  const HostedAgent* waiting = first_without_world();
  if (waiting == nullptr || now - began_ < kSayWaitingAfter) return;
  if (said_waiting_ && now - *said_waiting_ < kSayWaitingAgain) return;
  spdlog::info("waiting for the world: nothing on {} yet", idl::name_for(idl::kSensors, waiting->robot()));
  said_waiting_ = now;
}

AgentShell::Wall AgentShell::next_deadline(Wall now) const {
  const bool idle = said_waiting_ && first_without_world() == &agents_.front();
  Wall deadline = now + (idle ? Wall::duration{kSayWaitingAgain} : Wall::duration{kWatchPeriod});
  if (const auto clash = clash_->deadline()) deadline = std::min(deadline, *clash);
  return deadline;
}

int AgentShell::run() {
  for (;;) {
    Wall deadline;
    {
      const std::lock_guard lock{mutex_};
      const Wall now = std::chrono::steady_clock::now();
      watch(now);
      deadline = next_deadline(now);
    }
    if (loop_.wait(deadline) != runtime::Loop::Woken::kStop) {
      if (loop_.was_suspended_for(lease_s_)) throw runtime::BeginAnew{"suspended for longer than the lease"};
      continue;
    }
    const std::lock_guard lock{mutex_};
    if (clash_->must_be_silent()) return runtime::kDone;
    for (HostedAgent& agent : agents_) agent.halt();
    return runtime::kDone;
  }
}

}  // namespace caravan::agent
