// SPDX-License-Identifier: Apache-2.0
#include "deploy/observer/listen.hpp"

#include <utility>

#include "idl/robot_types.hpp"
#include "idl/world_types.hpp"

namespace caravan::deploy {
namespace msg = caravan_interfaces::msg;
using runtime::Discovery;
using runtime::Sender;
using runtime::Tenure;

namespace {

// Number of samples kept of a world that starts before its predecessor is gone, until that is noticed: as
// many truths as it may run ahead of an observer, and its statuses.
constexpr std::size_t kKeptOfWorld = idl::kMaxStepsAhead + 64;
constexpr std::size_t kMostEarly = 64;
constexpr std::size_t kMostImpostors = 32;

}  // namespace

RunReaders::RunReaders(std::uint32_t robots, Worlds worlds, Listener listener)
    : worlds_{worlds}, listener_{std::move(listener)}, world_{kKeptOfWorld}, agents_(robots) {
  for (std::uint32_t robot = 1; robot <= robots; ++robot) {
    for (const idl::Topic* topic : {&idl::kSensors, &idl::kRadioReceive})
      of_agents_.emplace(idl::name_for(*topic, robot), topic);
  }
}

void RunReaders::discovered(const Discovery& news) {
  if (news.kind == Discovery::Kind::kJoined || news.kind == Discovery::Kind::kReaderFound) return;
  const std::lock_guard lock{news_mutex_};
  if (news.kind != Discovery::Kind::kWriterFound) return news_.push_back(news);
  const auto topic = of_agents_.find(news.topic);
  if (topic == of_agents_.end() || impostors_.size() >= kMostImpostors) return;
  if (claim_of(*topic->second, news.identity) != runtime::Claim::kFull)
    impostors_.insert(to_text(news.participant, news.identity) + ": writes " + news.topic);
}

std::vector<std::string> RunReaders::impostors() const {
  const std::lock_guard lock{news_mutex_};
  return {impostors_.begin(), impostors_.end()};
}

void RunReaders::join(runtime::Bus& bus) {
  bus_ = &bus;
  for (std::uint32_t robot = 1; robot <= agents_.size(); ++robot) {
    bus.reader<msg::TelemetryPubSubType>(idl::kTelemetry, robot,
                                         [this, robot](const Telemetry& sample, const Sender& sender) {
                                           on_telemetry(robot, sample, sender);
                                         });
  }
  bus.reader<msg::WorldTruthPubSubType>(idl::kTruth, 0,
                                        [this](const msg::WorldTruth& sample, const Sender& sender) {
                                          on_world(idl::kTruth, sample, sender, listener_.truth);
                                        });
  bus.reader<msg::WorldStatusPubSubType>(idl::kWorldStatus, 0,
                                         [this](const msg::WorldStatus& sample, const Sender& sender) {
                                           on_world(idl::kWorldStatus, sample, sender, listener_.world);
                                         });
  bus.reader<msg::RadioStatusPubSubType>(
      idl::kRadioStatus, 0,
      [this](const msg::RadioStatus& sample, const Sender& sender) { on_radio(sample, sender); });
}

template <typename Sample>
void RunReaders::on_world(const idl::Topic& topic, const Sample& sample, const Sender& sender,
                          const std::function<void(const Sample&)>& handle) {
  const std::lock_guard lock{mutex_};
  read_news();
  const auto take = [this, &handle](const Sample& one) {
    follow_session(one.session());
    handle(one);
  };
  if (world_.claim(sender) != Tenure::Standing::kRefused) return take(sample);
  bus_->refuse(sender, topic);
  world_.keep(sender, [take, sample] { take(sample); });
}

void RunReaders::on_radio(const msg::RadioStatus& sample, const Sender& sender) {
  const std::lock_guard lock{mutex_};
  read_news();
  if (radio_.claim(sender) != Tenure::Standing::kRefused) return listener_.radio(sample);
  bus_->refuse(sender, idl::kRadioStatus);
  radio_.keep(sender, [this, sample] { listener_.radio(sample); });
}

void RunReaders::on_telemetry(std::uint32_t robot, const Telemetry& sample, const Sender& sender) {
  const std::lock_guard lock{mutex_};
  read_news();
  if (sample.session() == session_) return take_telemetry(robot, sample, sender);
  auto& early = agents_[robot - 1].early;
  if (sample.session() > session_ && early.size() < kMostEarly) early.push_back({sender, sample});
}

void RunReaders::take_telemetry(std::uint32_t robot, const Telemetry& sample, const Sender& sender) {
  Tenure& agent = agents_[robot - 1].tenure;
  if (agent.claim(sender) != Tenure::Standing::kRefused) return listener_.telemetry(robot, sample);
  bus_->refuse(sender, idl::kTelemetry, robot);
  agent.keep(sender, [this, robot, sample] { listener_.telemetry(robot, sample); });
}

void RunReaders::follow_session(std::uint64_t session) {
  if (session == session_) return;
  session_ = session;
  for (std::uint32_t robot = 1; robot <= agents_.size(); ++robot) {
    for (const Early& one : std::exchange(agents_[robot - 1].early, {})) {
      if (one.sample.session() == session_) take_telemetry(robot, one.sample, one.sender);
    }
  }
}

void RunReaders::read_news() {
  std::vector<Discovery> news;
  {
    const std::lock_guard lock{news_mutex_};
    news.swap(news_);
  }
  for (const Discovery& one : news) forget(one);
}

void RunReaders::forget(const Discovery& gone) {
  const auto concerns = [&gone](const idl::Topic& topic, std::uint32_t robot = 0) {
    return gone.kind == Discovery::Kind::kGone || gone.topic == idl::name_for(topic, robot);
  };
  if (worlds_ == Worlds::kNext && concerns(idl::kTruth) && world_.release(gone.participant))
    hand_over(world_);
  if (concerns(idl::kRadioStatus) && radio_.release(gone.participant)) hand_over(radio_);
  for (std::uint32_t robot = 1; robot <= agents_.size(); ++robot) {
    Tenure& agent = agents_[robot - 1].tenure;
    if (concerns(idl::kTelemetry, robot) && agent.release(gone.participant)) hand_over(agent);
  }
}

void RunReaders::hand_over(Tenure& tenure) {
  for (const Tenure::Later& take : tenure.hand_over()) take();
  if (const auto holder = tenure.holder()) bus_->forgive(*holder);
}

}  // namespace caravan::deploy
