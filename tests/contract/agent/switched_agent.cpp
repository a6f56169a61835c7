// SPDX-License-Identifier: Apache-2.0
// An agent that follows the rules, or breaks the one that --fault names: shows what the contract suite finds.
#include <CLI/CLI.hpp>

#include <limits>
#include <mutex>
#include <optional>

#include "idl/robot_types.hpp"
#include "idl/stamp.hpp"
#include "runtime/bus/bus.hpp"
#include "runtime/bus/tenure.hpp"
#include "runtime/process/loop.hpp"

namespace caravan::test {
namespace {

namespace msg = caravan_interfaces::msg;
using Wall = std::chrono::steady_clock::time_point;

class SwitchedAgent {
 public:
  SwitchedAgent(const runtime::BusConfig& config, std::uint32_t robot, std::string fault)
      : fault_{std::move(fault)}, robot_{robot}, bus_{config, [this](const auto& news) { meet(news); }} {
    commands_ = bus_.writer<msg::RobotCommandPubSubType>(idl::kCommand, robot);
    transmits_ = bus_.writer<msg::RadioTransmitPubSubType>(idl::kRadioTransmit, robot);
    telemetry_ = bus_.writer<msg::TelemetryPubSubType>(idl::kTelemetry, robot);
    bus_.reader<msg::RadioReceivePubSubType>(
        idl::kRadioReceive, robot, [this](const msg::RadioReceive& sample, const auto&) { hear(sample); });
    bus_.reader<msg::SensorFramePubSubType>(
        idl::kSensors, robot,
        [this](const msg::SensorFrame& frame, const runtime::Sender& sender) { sense(frame, sender); });
  }
  ~SwitchedAgent() { bus_.close(); }
  SwitchedAgent(const SwitchedAgent&) = delete;
  SwitchedAgent& operator=(const SwitchedAgent&) = delete;

  /// Steps without a radio that has not come in time.
  void catch_up(Wall now) {
    const std::lock_guard lock{mutex_};
    if (waiting_ && now >= until_) step(*std::exchange(waiting_, std::nullopt));
  }

 private:
  [[nodiscard]] bool has(const char* fault) const { return fault_ == fault; }

  void meet(const runtime::Discovery& news) {
    using Kind = runtime::Discovery::Kind;
    const bool is_writer = news.topic == idl::name_for(idl::kSensors, robot_);
    if (news.kind != Kind::kGone && !(news.kind == Kind::kWriterGone && is_writer)) return;
    const std::lock_guard lock{mutex_};
    if (!provider_.release(news.participant)) return;
    for (const auto& take : provider_.hand_over()) take();
  }
  void sense(const msg::SensorFrame& frame, const runtime::Sender& sender) {
    const std::lock_guard lock{mutex_};
    if (provider_.claim(sender) != runtime::Tenure::Standing::kRefused || has("two_worlds"))
      return take(frame);
    provider_.keep(sender, [this, frame] { take(frame); });
  }
  void hear(const msg::RadioReceive& sample) {
    const std::lock_guard lock{mutex_};
    if (sample.session() < session_ || (sample.session() > session_ && has("forgets_radio"))) return;
    heard_ = {sample.session(), idl::to_time(sample.stamp())};
    if (waiting_ && has_heard(*waiting_) && !has("always_waits"))
      step(*std::exchange(waiting_, std::nullopt));
  }
  [[nodiscard]] bool has_heard(const msg::SensorFrame& frame) const {
    return heard_.first == frame.session() && heard_.second >= idl::to_time(frame.stamp());
  }
  void take(const msg::SensorFrame& frame) {
    const auto stamp = idl::to_time(frame.stamp());
    if (frame.session() < session_ && !has("any_session")) return;
    if (frame.session() != session_) {
      session_ = frame.session();
      last_.reset();
      if (!has("no_reset")) steps_ = 0;
    }
    if (last_ && stamp <= *last_ && !has("repeats")) return;
    if (has("no_gaps") && last_ && stamp - *last_ > std::chrono::milliseconds{32}) return;
    if (has("busy")) {
      // Takes no other frame until it has answered this one, 200 ms later.
      if (!waiting_) postpone(frame, std::chrono::milliseconds{200});
      return;
    }
    if (has("late") && !last_ && steps_ == 0 && std::exchange(is_late_, false)) return;
    if (frame.radio_due() && !has("no_wait") && (!has_heard(frame) || has("always_waits")))
      return postpone(frame, std::chrono::seconds{1});
    step(frame);
  }
  void postpone(const msg::SensorFrame& frame, std::chrono::milliseconds time) {
    waiting_ = frame;
    until_ = std::chrono::steady_clock::now() + time;
  }
  void step(const msg::SensorFrame& frame) {
    last_ = idl::to_time(frame.stamp());
    ++steps_;
    const bool reports = steps_ % 5 == 0;
    msg::RobotCommand command;
    if (!has("no_stamp")) command.stamp(frame.stamp());
    command.session(frame.session());
    command.left_mps(0.1 + 0.001 * static_cast<double>(steps_));
    command.right_mps(0.1);
    if (has("not_finite") && !(frame.gps_x_m() < 1e9))
      command.left_mps(std::numeric_limits<double>::quiet_NaN());
    command.reported(reports && !has("says_no_report"));
    msg::RadioTransmit transmit;
    transmit.stamp(frame.stamp());
    transmit.session(frame.session());
    msg::Telemetry telemetry;
    telemetry.stamp(frame.stamp());
    telemetry.session(frame.session());
    if (has("other_order")) transmits_.write(transmit);
    if (reports) telemetry_.write(telemetry);
    commands_.write(command);
    if (!has("other_order") && !has("no_radio")) transmits_.write(transmit);
  }

  const std::string fault_;
  const std::uint32_t robot_;
  std::mutex mutex_;
  runtime::Tenure provider_;
  std::uint64_t session_ = 0;
  std::optional<std::chrono::nanoseconds> last_;
  std::uint64_t steps_ = 0;
  bool is_late_ = true;
  std::pair<std::uint64_t, std::chrono::nanoseconds> heard_{0, -1};  // session and stamp of the newest
  std::optional<msg::SensorFrame> waiting_;
  Wall until_{};
  runtime::Writer<msg::RobotCommandPubSubType> commands_;
  runtime::Writer<msg::RadioTransmitPubSubType> transmits_;
  runtime::Writer<msg::TelemetryPubSubType> telemetry_;
  runtime::Bus bus_;  // last, so that no callback outlives the rest
};

}  // namespace
}  // namespace caravan::test

int main(int argc, char** argv) {
  using namespace caravan;
  std::string scenario;
  std::string transport = "shm";
  std::string fault;
  std::uint32_t robot = 1;
  runtime::BusConfig config{.role = ""};
  CLI::App app{"An agent that follows the rules, or breaks one", "switched_agent"};
  app.add_option("--scenario", scenario, "Not read");
  app.add_option("--domain", config.domain, "DDS domain");
  app.add_option("--lease", config.lease_s, "Lease, s");
  app.add_option("--transport", transport, "shm, udp or a profile");
  app.add_option("--robot", robot, "Number of the robot");
  app.add_option("--fault", fault, "The fault, by its name in the code");
  CLI11_PARSE(app, argc, argv);
  config.transport = runtime::transport_named(transport);
  config.role = "switched_agent";
  runtime::Loop loop;
  test::SwitchedAgent agent{config, robot, fault};
  while (loop.wait(std::chrono::steady_clock::now() + std::chrono::milliseconds{50}) !=
         runtime::Loop::Woken::kStop)
    agent.catch_up(std::chrono::steady_clock::now());
  return 0;
}
