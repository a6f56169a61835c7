// SPDX-License-Identifier: Apache-2.0
#include "deploy/launcher/observer.hpp"

#include <utility>

#include "deploy/launcher/listen.hpp"
#include "idl/stamp.hpp"

namespace caravan::deploy {
namespace msg = caravan_interfaces::msg;

namespace {

constexpr std::size_t kWorthALook = 32;  // steps; an eighth of what the world may run ahead

}  // namespace

Observer::Observer(const runtime::BusConfig& bus, const std::string& name, std::uint32_t robots,
                   runtime::Loop& loop)
    : loop_{loop}, name_{name}, bus_{bus} {
  credit_ = bus_.writer<msg::RunCreditPubSubType>(idl::kRunCredit);
  listen(bus_, robots,
         {.truth =
              [this](const msg::WorldTruth& sample) {
                const std::lock_guard lock{mutex_};
                book_.add(sample);
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
                news_.radio = sample;
              },
          .telemetry =
              [this](std::uint32_t robot, const msg::Telemetry& sample) {
                const std::lock_guard lock{mutex_};
                book_.add(robot, sample);
                tell(false);
              }});
  give_credit(Time{0});
}

Observer::~Observer() { bus_.close(); }

void Observer::tell(bool is_last) {
  if (is_last || book_.whole_steps() >= kWorthALook) loop_.notify();
}

Observer::News Observer::look() {
  const std::lock_guard lock{mutex_};
  News taken = news_;
  taken.observations = book_.take();
  for (const Observation& step : taken.observations) taken.last_seen = taken.last_seen || step.last;
  taken.agents_compute_s = book_.agents_compute_s();
  return taken;
}

void Observer::give_credit(Time stamp) {
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
