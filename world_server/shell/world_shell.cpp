// SPDX-License-Identifier: Apache-2.0
#include "world_server/shell/world_shell.hpp"

#include <cmath>
#include <utility>

namespace caravan::world {
namespace msg = caravan_interfaces::msg;
using runtime::Discovery;
using runtime::Sender;

namespace {

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

ControlConfig control_config(const WorldConfig& config) {
  const runtime::Pacing pacing = config.experiment.pacing;
  return {.robots = config.robots.count,
          .speed = pacing == runtime::Pacing::kFast ? 0.0 : 1.0,
          .follows_clock = pacing == runtime::Pacing::kFree};
}

}  // namespace

WorldShell::WorldShell(const WorldConfig& config, const runtime::BusConfig& bus,
                       const std::vector<std::string>& awaited, std::unique_ptr<runtime::TraceFile> trace,
                       runtime::Loop& loop)
    : config_{config},
      follows_clock_{config.experiment.pacing == runtime::Pacing::kFree},
      loop_{loop},
      lease_s_{bus.lease_s},
      session_{new_session()},
      period_{period_of(config)},
      trace_{std::move(trace)},
      world_{config},
      barrier_{barrier_config(config)},
      lockstep_{follows_clock_},
      inputs_{config.robots.count},
      pace_{period_},
      control_{control_config(config)},
      credits_{awaited},
      drivers_(config.robots.count),
      tallies_{config.robots.count},
      bus_{bus,
           [this](const Discovery& news) {
             if (news.kind != Discovery::Kind::kJoined && news.kind != Discovery::Kind::kReaderFound)
               mailbox_.post(news);
           }},
      outputs_{config_, session_, period_, bus_} {
  publish_sensors();
  // Without the lock: creating a reader waits for DDS's own locks, whose holders may be waiting for ours in a
  // callback.
  for (std::uint32_t robot = 1; robot <= config_.robots.count; ++robot) {
    bus_.reader<msg::RobotCommandPubSubType>(
        command_topic(robot), robot, [this, robot](const msg::RobotCommand& sample, const Sender& sender) {
          on_command(robot, sample, sender);
        });
  }
  bus_.reader<msg::RadioStepPubSubType>(
      idl::kRadioStep, 0,
      [this](const msg::RadioStep& sample, const Sender& sender) { on_radio_step(sample, sender); });
  bus_.reader<msg::RunCreditPubSubType>(
      idl::kRunCredit, 0,
      [this](const msg::RunCredit& sample, const Sender& sender) { on_credit(sample, sender); });
  bus_.reader<msg::ControlRequestPubSubType>(
      idl::kControlRequest, 0,
      [this](const msg::ControlRequest& request, const Sender& /*sender*/) { on_control(request); });
}

WorldShell::~WorldShell() { bus_.close(); }

}  // namespace caravan::world
