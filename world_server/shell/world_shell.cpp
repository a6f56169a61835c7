// SPDX-License-Identifier: Apache-2.0
#include "world_server/shell/world_shell.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

#include "idl/stamp.hpp"
#include "runtime/process/run_process.hpp"
#include "runtime/pure/digest.hpp"
#include "runtime/pure/hash_chain.hpp"
#include "world_server/referee/sanitise.hpp"
#include "world_server/shell/wire.hpp"

namespace caravan::world {
namespace msg = caravan_interfaces::msg;
using runtime::Discovery;
using runtime::Pacing;
using runtime::ParticipantId;
using namespace std::chrono_literals;

namespace {

constexpr Time kDeadman = 600ms;  // free pacing: how long a command holds

/// Sessions of later starts have higher numbers.
std::uint64_t new_session() {
  return static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
}

Time period_of(const WorldConfig& config) { return Time{std::llround(config.step_s * 1e9)}; }

BarrierConfig barrier_config(const WorldConfig& config) {
  BarrierConfig barrier;
  barrier.robots = config.robots.count;
  barrier.waits_for_hung = config.experiment.on_hung == runtime::OnHung::kWait;
  return barrier;
}

}  // namespace

WorldShell::WorldShell(const WorldConfig& config, const runtime::BusConfig& bus,
                       const std::vector<std::string>& awaited, runtime::Loop& loop)
    : config_{config},
      loop_{loop},
      session_{new_session()},
      period_{period_of(config)},
      world_{config},
      barrier_{barrier_config(config)},
      credits_{awaited},
      commands_(config.robots.count),
      commanded_at_(config.robots.count),
      robot_owners_(config.robots.count),
      radio_due_(config.robots.count, false),
      radio_chain_{pure::HashChain{}.value()},
      bus_{bus, [this](const Discovery& news) {
             if (news.kind != Discovery::Kind::kGone) return;
             const std::lock_guard lock{mailbox_mutex_};
             mailbox_.push_back(news);
             loop_.notify();
           }} {
  for (std::uint32_t robot = 1; robot <= config_.robots.count; ++robot) {
    sensors_.push_back(bus_.writer<msg::SensorFramePubSubType>(idl::kSensors, robot));
  }
  truths_ = bus_.writer<msg::WorldTruthPubSubType>(idl::kTruth);
  clock_ = bus_.writer<rosgraph_msgs::msg::ClockPubSubType>(idl::kClock);
  statuses_ = bus_.writer<msg::WorldStatusPubSubType>(idl::kWorldStatus);
  publish_sensors();
  // Not under the lock: making a reader waits for DDS's own locks, whose holders may be waiting for ours in a
  // callback.
  for (std::uint32_t robot = 1; robot <= config_.robots.count; ++robot) {
    bus_.reader<msg::RobotCommandPubSubType>(
        idl::kCommand, robot, [this, robot](const msg::RobotCommand& sample, const ParticipantId& sender) {
          on_command(robot, sample, sender);
        });
  }
  bus_.reader<msg::RadioStepPubSubType>(
      idl::kRadioStep, 0,
      [this](const msg::RadioStep& sample, const ParticipantId& sender) { on_radio_step(sample, sender); });
  bus_.reader<msg::RunCreditPubSubType>(
      idl::kRunCredit, 0,
      [this](const msg::RunCredit& sample, const ParticipantId& sender) { on_credit(sample, sender); });
}

WorldShell::~WorldShell() { bus_.close(); }

// ---------------------------------------------------------------------------------------------- what arrives

bool WorldShell::is_current(std::uint64_t session, Time stamp) const {
  if (session != session_ || phase_ == Phase::kFinished) return false;
  return config_.experiment.pacing == Pacing::kFree ? stamp_ - stamp <= kDeadman : stamp == stamp_;
}

bool WorldShell::owns(std::optional<ParticipantId>& owner, const ParticipantId& sender) {
  if (!owner) owner = sender;
  return *owner == sender;
}

void WorldShell::on_command(std::uint32_t robot, const msg::RobotCommand& sample,
                            const ParticipantId& sender) {
  const std::lock_guard lock{mutex_};
  if (!is_current(sample.session(), idl::to_time(sample.stamp())) ||
      !owns(robot_owners_[robot - 1], sender)) {
    ++tallies_.stale_samples;
    return;
  }
  const Sanitised safe = sanitise(sample.left_mps(), sample.right_mps(), config_.robots.wheel_limit_mps);
  if (safe.refused && tallies_.refused_commands++ == 0) {
    spdlog::warn(
        "command refused robot={}: not finite, its wheels stop (further ones are counted in the status)",
        robot);
  }
  if (safe.clamped && tallies_.clamped_commands++ == 0) {
    spdlog::warn(
        "command clamped robot={}: beyond the wheel limit of {} m/s (further ones are counted in the status)",
        robot, config_.robots.wheel_limit_mps);
  }
  const Answer answer = barrier_.answer(robot);
  if (answer != Answer::kNextStep || phase_ == Phase::kWaiting) {
    commands_[robot - 1] = Command{safe.left_mps, safe.right_mps, sample.gripper_closed()};
    commanded_at_[robot - 1] = stamp_;
  }
  if (answer == Answer::kRevives) publish_truth(false);
  progress();
}

void WorldShell::on_radio_step(const msg::RadioStep& sample, const ParticipantId& sender) {
  const std::lock_guard lock{mutex_};
  if (!is_current(sample.session(), idl::to_time(sample.stamp())) || !owns(radio_owner_, sender)) {
    ++tallies_.stale_samples;
    return;
  }
  for (const std::uint32_t robot : sample.receivers()) {
    if (robot >= 1 && robot <= radio_due_.size()) radio_due_[robot - 1] = true;
  }
  radio_chain_ = sample.chain();
  barrier_.answer_radio();
  progress();
}

void WorldShell::on_credit(const msg::RunCredit& sample, const ParticipantId& sender) {
  const std::lock_guard lock{mutex_};
  const bool ours = sample.session() == session_;
  credits_.give(sample.observer(), sender, ours ? idl::to_time(sample.stamp()) : Time{0});
  progress();
}

// ---------------------------------------------------------------------------------------------- the step

void WorldShell::read_mailbox() {
  std::vector<Discovery> news;
  {
    const std::lock_guard lock{mailbox_mutex_};
    news.swap(mailbox_);
  }
  for (const Discovery& one : news) forget(one);
}

void WorldShell::forget(const Discovery& gone) {
  credits_.lose(gone.participant);
  bool members_changed = false;
  for (std::uint32_t robot = 1; robot <= config_.robots.count; ++robot) {
    if (robot_owners_[robot - 1] != gone.participant) continue;
    spdlog::warn("robot lost robot={} pid={} host={}", robot, gone.identity.pid, gone.identity.host);
    robot_owners_[robot - 1].reset();
    members_changed = barrier_.lose(robot, std::chrono::steady_clock::now()) || members_changed;
    commands_[robot - 1].reset();
  }
  if (radio_owner_ == gone.participant) {
    spdlog::warn("radio lost pid={} host={}: the robots drive on alone", gone.identity.pid,
                 gone.identity.host);
    radio_owner_.reset();
    barrier_.lose_radio();
    radio_due_.assign(radio_due_.size(), false);
  }
  if (members_changed && (phase_ == Phase::kOpen || phase_ == Phase::kAdvanced)) publish_truth(false);
}

void WorldShell::progress() {
  read_mailbox();
  const bool free = config_.experiment.pacing == Pacing::kFree;
  for (;;) {
    switch (phase_) {
      case Phase::kWaiting:
        if (!barrier_.missing().empty() || !credits_.missing().empty()) return;
        tallies_.started = tallies_.last_status = due_ = std::chrono::steady_clock::now();
        spdlog::info("started robots={} session={}", config_.robots.count, session_);
        open_step();
        break;
      case Phase::kOpen:
        if (free || !barrier_.commands_in()) return;
        advance();
        break;
      case Phase::kAdvanced:
        if (free || !barrier_.radio_in()) return;
        phase_ = Phase::kClosed;
        break;
      case Phase::kClosed:
        if (world_.finished()) return finish();
        if (!may_open(std::chrono::steady_clock::now())) return;
        open_step();
        break;
      case Phase::kFinished:
        return;
    }
  }
}

bool WorldShell::may_open(Wall now) {
  const auto held_by = credits_.holding_back(world_.now(), period_ * idl::kMaxStepsAhead);
  if (held_by && !named_hold_) spdlog::debug("held back by observer={}", *held_by);
  named_hold_ = held_by.has_value();
  if (named_hold_) return false;
  if (config_.experiment.pacing == Pacing::kFast || now >= due_) return true;
  loop_.notify();  // the main thread opens it when it is due
  return false;
}

void WorldShell::open_step() {
  const bool first = phase_ == Phase::kWaiting;
  const Wall now = std::chrono::steady_clock::now();
  stamp_ = world_.now();
  barrier_.open(now);
  phase_ = Phase::kOpen;
  due_ = now - due_ > 100ms ? now + period_ : due_ + period_;  // a hold is not caught up with
  if (!first) publish_sensors();  // the first frames have been out since the start
  publish_truth(false);
}

void WorldShell::publish_sensors() {
  const bool lockstep = config_.experiment.pacing != Pacing::kFree;
  rosgraph_msgs::msg::Clock clock;
  clock.clock(idl::to_wire(stamp_));
  clock_.write(clock);
  frame_.stamp(idl::to_wire(stamp_));
  frame_.session(session_);
  for (std::uint32_t robot = 1; robot <= config_.robots.count; ++robot) {
    {
      const Stopwatch watch{tallies_.sensors};
      to_wire(world_.sense(robot), frame_);
    }
    frame_.radio_due(lockstep && radio_due_[robot - 1]);
    if (!sensors_[robot - 1].write(frame_)) ++tallies_.refused_writes;
  }
  radio_due_.assign(radio_due_.size(), false);
}

void WorldShell::publish_truth(bool last) {
  to_wire(world_, barrier_.members(), truth_);
  truth_.stamp(idl::to_wire(stamp_));
  truth_.next_stamp(idl::to_wire(stamp_ + period_));
  truth_.session(session_);
  truth_.last(last);
  if (last) truth_.members().clear();
  if (!truths_.write(truth_)) ++tallies_.refused_writes;
}

void WorldShell::advance() {
  const Stopwatch watch{tallies_.physics};
  world_.advance(commands_);
  if (config_.experiment.pacing != Pacing::kFree) commands_.assign(commands_.size(), std::nullopt);
  phase_ = Phase::kAdvanced;
}

void WorldShell::finish() {
  phase_ = Phase::kFinished;
  stamp_ = world_.now();
  tallies_.ended = std::chrono::steady_clock::now();
  digest_ = pure::digest(world_.chain(), radio_chain_);
  publish_truth(true);
  publish_status(tallies_.ended);
  spdlog::info("finished sim_s={:.3f} items={} digest={}", std::chrono::duration<double>(stamp_).count(),
               world_.items_delivered(), digest_);
}

// ---------------------------------------------------------------------------------------------- the main
// thread

int WorldShell::run() {
  const Wall began = std::chrono::steady_clock::now();
  const auto patience = std::chrono::duration_cast<Wall::duration>(
      std::chrono::duration<double>(config_.experiment.start_timeout_s));
  for (;;) {
    Wall deadline;
    {
      const std::lock_guard lock{mutex_};
      const Wall now = std::chrono::steady_clock::now();
      watch(now);
      if (phase_ == Phase::kWaiting && now - began > patience) {
        spdlog::error("nobody to start with after {} s: {} missing", config_.experiment.start_timeout_s,
                      fmt::join(missing(), ", "));
        return runtime::kCouldNotStart;
      }
      deadline = next_deadline(now);
    }
    if (loop_.wait(deadline) == runtime::Loop::Woken::kStop) return runtime::kDone;
  }
}

void WorldShell::watch(Wall now) {
  progress();
  if (config_.experiment.pacing == Pacing::kFree && phase_ == Phase::kOpen && now >= due_) free_step(now);
  if (barrier_.let_go(now)) {
    publish_truth(false);
    progress();
  }
  if (now >= status_due_) {
    name_the_late(now);
    publish_status(now);
  }
}

void WorldShell::free_step(Wall /*now*/) {
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    if (commands_[i] && stamp_ - commanded_at_[i] > kDeadman) commands_[i].reset();
  }
  advance();
  phase_ = Phase::kClosed;
  if (world_.finished()) return finish();
  open_step();
}

Wall WorldShell::next_deadline(Wall now) const {
  const bool paced =
      config_.experiment.pacing != Pacing::kFast && !named_hold_ &&
      (phase_ == Phase::kClosed || (phase_ == Phase::kOpen && config_.experiment.pacing == Pacing::kFree));
  return paced ? std::min(status_due_, std::max(due_, now)) : status_due_;
}

std::vector<std::string> WorldShell::missing() const {
  std::vector<std::string> names = credits_.missing();
  if (phase_ != Phase::kWaiting) return names;
  for (const std::uint32_t robot : barrier_.missing()) names.push_back("robot " + std::to_string(robot));
  return names;
}

}  // namespace caravan::world
