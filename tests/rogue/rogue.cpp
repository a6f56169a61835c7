// SPDX-License-Identifier: Apache-2.0
// rogue: a stranger in the domain of a run. Once the run has begun it writes forged and corrupted samples on
// every topic, at a given rate for a given time, and prints their number at its end. With --role it states a
// role of ours.
#include <CLI/CLI.hpp>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "idl/clock_types.hpp"
#include "runtime/bus/bus.hpp"
#include "runtime/bus/transport.hpp"
#include "tests/rogue/forger.hpp"
#include "tests/rogue/raw_type.hpp"

namespace caravan::test {
namespace {

namespace msg = caravan_interfaces::msg;
using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t stopped = 0;

struct Plan {
  std::uint32_t domain = 0;
  std::uint32_t seed = 1;
  std::uint32_t robots = 4;
  double seconds = 5.0;
  double rate = 200.0;  // samples per second
  std::string role = "rogue";
  std::string transport = "shm";
};

runtime::BusConfig bus_config(const Plan& plan, const std::string& role) {
  return {.role = role,
          .domain = plan.domain,
          .lease_s = 5.0,
          .transport = runtime::transport_named(plan.transport)};
}

/// Follows the run's truth.
class Spy {
 public:
  explicit Spy(const Plan& plan) : bus_{bus_config(plan, "rogue")} {
    bus_.reader<msg::WorldTruthPubSubType>(idl::kTruth, 0, [this](const msg::WorldTruth& truth, const auto&) {
      const std::lock_guard lock{mutex_};
      known_ = {truth.session(), idl::to_time(truth.stamp()), idl::to_time(truth.next_stamp())};
    });
  }
  [[nodiscard]] Known known() const {
    const std::lock_guard lock{mutex_};
    return known_;
  }

 private:
  mutable std::mutex mutex_;
  Known known_;
  runtime::Bus bus_;
};

/// A writer of every topic.
class Rogue {
 public:
  explicit Rogue(const Plan& plan) : forger_{plan.seed, plan.robots}, bus_{bus_config(plan, plan.role)} {
    for (std::uint32_t robot = 1; robot <= plan.robots; ++robot) {
      add<msg::SensorFramePubSubType>(idl::kSensors, robot);
      add<msg::RobotCommandPubSubType>(idl::kCommand, robot);
      add<msg::RadioTransmitPubSubType>(idl::kRadioTransmit, robot);
      add<msg::RadioReceivePubSubType>(idl::kRadioReceive, robot);
      add<msg::TelemetryPubSubType>(idl::kTelemetry, robot);
      add<msg::SensorFramePubSubType>(idl::kBodySensors, robot);
      add<msg::RobotCommandPubSubType>(idl::kBodyCommand, robot);
    }
    add<msg::WorldTruthPubSubType>(idl::kTruth, 0);
    add<msg::RadioStepPubSubType>(idl::kRadioStep, 0);
    add<rosgraph_msgs::msg::ClockPubSubType>(idl::kClock, 0);
    add<msg::WorldStatusPubSubType>(idl::kWorldStatus, 0);
    add<msg::RadioStatusPubSubType>(idl::kRadioStatus, 0);
    add<msg::RunCreditPubSubType>(idl::kRunCredit, 0);
    add<msg::ControlRequestPubSubType>(idl::kControlRequest, 0);
    add<msg::ControlReplyPubSubType>(idl::kControlReply, 0);
  }
  /// Writes one sample on one topic.
  void strike(const Known& known) {
    forger_.know(known);
    attacks_[forger_.below(static_cast<std::uint32_t>(attacks_.size()))]();
  }

 private:
  template <typename PubSubType>
  void add(const idl::Topic& topic, std::uint32_t robot) {
    auto writer = bus_.writer<RawType<PubSubType>, RawType<PubSubType>>(topic, robot);
    attacks_.emplace_back([this, writer]() mutable {
      Bytes bytes;
      const std::uint32_t way = forger_.below(8);
      if (way == 0) {
        bytes = forger_.noise();
      } else {
        typename PubSubType::type sample;
        forger_.forge(sample);
        bytes = bytes_of<PubSubType>(sample);
        if (way < 4) forger_.spoil(bytes);
      }
      writer.write(bytes);
    });
  }

  Forger forger_;
  runtime::Bus bus_;
  std::vector<std::function<void()>> attacks_;
};

int run(const Plan& plan) {
  std::signal(SIGTERM, [](int) { stopped = 1; });
  const Spy spy{plan};
  const auto patience = Clock::now() + std::chrono::seconds{60};
  while (spy.known().stamp <= std::chrono::nanoseconds{0}) {
    if (stopped != 0 || Clock::now() > patience)
      return std::fprintf(stderr, "no run in domain %u\n", plan.domain), 1;
    std::this_thread::sleep_for(std::chrono::milliseconds{5});
  }
  Rogue rogue{plan};
  std::printf("rogue \"%s\" begins, seed %u\n", plan.role.c_str(), plan.seed);
  std::fflush(stdout);
  const auto began = Clock::now();
  const auto period =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>{1.0 / plan.rate});
  std::uint64_t struck = 0;
  for (auto due = began; stopped == 0 && due - began < std::chrono::duration<double>{plan.seconds};
       due += period) {
    std::this_thread::sleep_until(due);
    rogue.strike(spy.known());
    ++struck;
  }
  std::printf("rogue \"%s\" has written %llu samples\n", plan.role.c_str(),
              static_cast<unsigned long long>(struck));
  return 0;
}

}  // namespace
}  // namespace caravan::test

int main(int argc, char** argv) {
  caravan::test::Plan plan;
  CLI::App app{"A stranger in the domain of a run"};
  app.add_option("--domain", plan.domain, "DDS domain of the run")->required();
  app.add_option("--seed", plan.seed, "Of what it writes")->capture_default_str();
  app.add_option("--robots", plan.robots, "Robots of the run, whose topics it writes")->capture_default_str();
  app.add_option("--seconds", plan.seconds, "For so long, once the run has begun")->capture_default_str();
  app.add_option("--rate", plan.rate, "Samples a second")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--role", plan.role, "What it says to be, such as \"robot_agent 1\" or world_server")
      ->capture_default_str();
  app.add_option("--transport", plan.transport, "DDS transport: shm, udp or a profile (FILE.xml)")
      ->check(caravan::runtime::complaint_about_transport)
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return caravan::test::run(plan);
}
