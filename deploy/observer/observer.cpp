// SPDX-License-Identifier: Apache-2.0
#include "deploy/observer/observer.hpp"

#include <utility>

#include "idl/stamp.hpp"

namespace caravan::deploy {
namespace msg = caravan_interfaces::msg;

namespace {

constexpr std::size_t kWorthALook = 32;  // steps; an eighth of the steps that the world may run ahead

}  // namespace

Observer::Observer(const runtime::BusConfig& bus, const std::string& name, std::uint32_t robots,
                   runtime::Loop& loop)
    : loop_{loop},
      name_{name},
      readers_{robots,
               RunReaders::Worlds::kOne,
               {.truth =
                    [this](const msg::WorldTruth& sample) {
                      const std::lock_guard lock{mutex_};
                      book_.add(sample);
                      if (sample.last()) ended_ = idl::to_time(sample.stamp());
                      tell(sample.last());
                    },
                .world =
                    [this](const msg::WorldStatus& sample) {
                      const std::lock_guard lock{mutex_};
                      news_.world = sample;
                      ++news_.world_statuses;
                      if (sample.state() == msg::WorldStatus_Constants::FINISHED) loop_.notify();
                    },
                .radio =
                    [this](const msg::RadioStatus& sample) {
                      const std::lock_guard lock{mutex_};
                      // The radio has left after its final counts; another participant with its role has
                      // none.
                      if (ended_ && news_.radio && idl::to_time(news_.radio->stamp()) >= *ended_) return;
                      news_.radio = sample;
                    },
                .telemetry =
                    [this](std::uint32_t robot, const msg::Telemetry& sample) {
                      const std::lock_guard lock{mutex_};
                      book_.add(robot, sample);
                      tell(false);
                    }}},
      bus_{bus, [this](const runtime::Discovery& news) { readers_.discovered(news); }} {
  credit_ = bus_.writer<msg::RunCreditPubSubType>(idl::kRunCredit);
  readers_.join(bus_);
  give_credit(experiment::Time{0});
}

Observer::~Observer() { bus_.close(); }

void Observer::tell(bool is_last) {
  if (is_last || book_.whole_steps() >= kWorthALook) loop_.notify();
}

Observer::News Observer::look() {
  const std::lock_guard lock{mutex_};
  News taken = news_;
  taken.observations = book_.take();
  for (const experiment::Observation& step : taken.observations)
    taken.last_seen = taken.last_seen || step.last;
  taken.agents_compute_s = book_.agents_compute_s();
  taken.strangers = strangers(taken);
  return taken;
}

std::vector<std::string> Observer::strangers(const News& news) const {
  std::vector<std::string> all = readers_.impostors();
  for (const runtime::Stranger& one : bus_.strangers()) all.push_back("launcher: " + to_text(one));
  if (news.world) {
    for (const std::string& one : news.world->strangers()) all.push_back("world: " + one);
  }
  if (news.radio) {
    for (const std::string& one : news.radio->strangers()) all.push_back("radio: " + one);
  }
  return all;
}

void Observer::give_credit(experiment::Time stamp) {
  msg::RunCredit credit;
  credit.observer(name_);
  {
    const std::lock_guard lock{mutex_};
    credit.session(book_.session());
  }
  credit.stamp(idl::to_wire(stamp));
  credit_.write(credit);
}

}  // namespace caravan::deploy
