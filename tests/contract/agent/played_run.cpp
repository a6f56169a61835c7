// SPDX-License-Identifier: Apache-2.0
#include "tests/contract/agent/played_run.hpp"

#include <signal.h>

#include <cmath>

namespace caravan::test {
namespace {

constexpr const char* kScenario = R"(name = "contract"
[robots]
count = 1
source_m = [-4.5, -4.5]
destination_m = [4.5, 4.5]
[experiment]
items = 1
max_time_s = 3600.0
[world]
arena_m = [12.0, 12.0]
start_low_m = [-5.4, -5.4]
start_high_m = [-2.8, -2.8]
)";

std::int64_t stamp_of(int step) { return std::chrono::nanoseconds{step * kStep}.count(); }

}  // namespace

Subject& subject() {
  static Subject one;
  return one;
}

msg::SensorFrame frame_of(std::uint64_t session, int step) {
  msg::SensorFrame frame;
  frame.stamp(idl::to_wire(step * kStep));
  frame.session(session);
  for (std::size_t i = 0; i < 16; ++i)
    frame.sonar_range_m()[i] = 0.4 + std::fmod(0.37 * step + 0.9 * static_cast<double>(i), 4.5);
  frame.gps_x_m(-4.5 + 0.01 * step);
  frame.gps_y_m(-4.5 + 0.007 * step);
  frame.compass_yaw_rad(std::sin(0.05 * step));
  frame.left_wheel_rad(0.1 * step);
  frame.right_wheel_rad(0.1 * step);
  return frame;
}

AgentUnderTest::~AgentUnderTest() {
  signal(SIGTERM);
  signal(SIGCONT);  // in case it is suspended
  (void)wait(10s);
}

PlayedWorld::PlayedWorld(const runtime::BusConfig& bus)
    : bus_{bus,
           [this](const runtime::Discovery& news) {
             const bool reads = news.kind == runtime::Discovery::Kind::kReaderFound &&
                                news.topic == idl::name_for(idl::kSensors, kRobot);
             const std::lock_guard lock{mutex_};
             has_reader_ = has_reader_ || reads;
           }},
      frames_{bus_.writer<msg::SensorFramePubSubType>(idl::kSensors, kRobot)} {}

bool PlayedWorld::has_reader() const {
  const std::lock_guard lock{mutex_};
  return has_reader_;
}

PlayedRadio::PlayedRadio(const runtime::BusConfig& bus)
    : bus_{bus}, receives_{bus_.writer<msg::RadioReceivePubSubType>(idl::kRadioReceive, kRobot)} {}

void PlayedRadio::send(std::uint64_t session, int step) {
  msg::RadioReceive receive;
  receive.stamp(idl::to_wire(step * kStep));
  receive.session(session);
  msg::ReceivedFrame heard;
  heard.bytes({0xC1, 0x01, 0x02, 0x00, 0x00, 0x00, 0x00, 0x00});  // WAIT_2_EXPLORE
  heard.signal_strength_dbm(std::nan(""));
  receive.frames({heard});
  receives_.write(receive);
}

Listener::Listener(const runtime::BusConfig& bus)
    : bus_{bus, [this](const runtime::Discovery& news) { meet(news); }} {
  bus_.reader<msg::TelemetryPubSubType>(
      idl::kTelemetry, kRobot,
      [this](const msg::Telemetry& sample, const auto&) { note(sample, &Answer::telemetry, 'T'); });
  bus_.reader<msg::RobotCommandPubSubType>(
      idl::kCommand, kRobot,
      [this](const msg::RobotCommand& sample, const auto&) { note(sample, &Answer::commands, 'C'); });
  bus_.reader<msg::RadioTransmitPubSubType>(
      idl::kRadioTransmit, kRobot,
      [this](const msg::RadioTransmit& sample, const auto&) { note(sample, &Answer::transmits, 'R'); });
}

template <typename Sample>
void Listener::note(const Sample& sample, std::vector<Sample> Answer::*samples, char letter) {
  const std::lock_guard lock{mutex_};
  Answer& answer = answers_[{sample.session(), idl::to_time(sample.stamp()).count()}];
  (answer.*samples).push_back(sample);
  answer.order += letter;
}

void Listener::meet(const runtime::Discovery& news) {
  using Kind = runtime::Discovery::Kind;
  const std::lock_guard lock{mutex_};
  const bool drives = news.topic == idl::name_for(idl::kCommand, kRobot);
  if (news.kind == Kind::kWriterFound && drives) {
    agents_.insert(news.participant);
    identity_ = news.identity;
  }
  if (news.kind == Kind::kReaderFound && news.topic == idl::name_for(idl::kRadioReceive, kRobot))
    uses_radio_ = true;
  if (news.kind == Kind::kGone || (news.kind == Kind::kWriterGone && drives)) agents_.erase(news.participant);
}

Answer Listener::answer(std::uint64_t session, int step) const {
  const std::lock_guard lock{mutex_};
  const auto found = answers_.find({session, stamp_of(step)});
  return found == answers_.end() ? Answer{} : found->second;
}

std::set<std::int64_t> Listener::steps() const {
  const std::lock_guard lock{mutex_};
  std::set<std::int64_t> steps;
  for (const auto& [key, answer] : answers_) {
    const bool is_whole = key.second % stamp_of(1) == 0;
    steps.insert(is_whole ? key.second / stamp_of(1) : -1);
  }
  return steps;
}

std::set<std::uint64_t> Listener::sessions() const {
  const std::lock_guard lock{mutex_};
  std::set<std::uint64_t> sessions;
  for (const auto& [key, answer] : answers_) sessions.insert(key.first);
  return sessions;
}

std::size_t Listener::agents() const {
  const std::lock_guard lock{mutex_};
  return agents_.size();
}

runtime::Identity Listener::identity() const {
  const std::lock_guard lock{mutex_};
  return identity_;
}

bool Listener::uses_radio() const {
  const std::lock_guard lock{mutex_};
  return uses_radio_;
}

std::unique_ptr<AgentUnderTest> AgentContract::start_agent() {
  std::filesystem::path scenario = subject().scenario;
  if (scenario.empty()) write_file(scenario = folder_ / "contract.toml", kScenario);
  std::vector<std::string> line{subject().program,
                                "--scenario",
                                scenario,
                                "--domain",
                                std::to_string(lock_.domain()),
                                "--lease",
                                std::to_string(short_lease_s()),
                                "--transport",
                                to_text(subject().transport),
                                "--robot",
                                std::to_string(kRobot)};
  line.insert(line.end(), subject().more.begin(), subject().more.end());
  return std::make_unique<AgentUnderTest>(line, folder_ / ("agent_" + std::to_string(++started_) + ".log"));
}

runtime::BusConfig AgentContract::bus(const std::string& role) const {
  return {
      .role = role, .domain = lock_.domain(), .lease_s = short_lease_s(), .transport = subject().transport};
}

bool AgentContract::commands(std::uint64_t session, int step, std::size_t times) const {
  return eventually([&] { return listener_.answer(session, step).commands.size() >= times; },
                    subject().patience);
}

bool AgentContract::transmits(std::uint64_t session, int step) const {
  return eventually([&] { return !listener_.answer(session, step).transmits.empty(); }, subject().patience);
}

void AgentContract::drive(std::uint64_t session, int from, int to) {
  for (int step = from; step <= to; ++step) {
    world_->send(frame_of(session, step));
    ASSERT_TRUE(commands(session, step)) << "no command answers session " << session << ", step " << step
                                         << ": a RobotCommand with its stamp is missing. " << log();
  }
}

bool AgentContract::agent_uses_radio() const {
  return eventually([&] { return listener_.uses_radio(); }, std::min(subject().patience, 5'000ms));
}

std::string AgentContract::log() const {
  std::string text = "The agent's output:\n";
  for (int agent = 1; agent <= started_; ++agent)
    text += read_file(folder_ / ("agent_" + std::to_string(agent) + ".log"));
  return text;
}

}  // namespace caravan::test
