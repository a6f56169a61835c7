// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/radio/pairing/can_communicate.hpp"

#include <algorithm>

#include "runtime/pure/assert.hpp"

namespace caravan::agent {
namespace {

bool comes_before(const Contact& contact, RobotId robot) { return contact.robot < robot; }

}  // namespace

const Contact* Contacts::find(RobotId robot) const {
  const auto place = std::lower_bound(contacts_.begin(), contacts_.end(), robot, comes_before);
  return place != contacts_.end() && place->robot == robot ? &*place : nullptr;
}

Contact& Contacts::at(RobotId robot) {
  const auto place = std::lower_bound(contacts_.begin(), contacts_.end(), robot, comes_before);
  if (place != contacts_.end() && place->robot == robot) return *place;
  return *contacts_.insert(place, Contact{robot});
}

void Contacts::avoid_until(RobotId robot, Time moment) {
  Contact& contact = at(robot);
  contact.again_from = std::max(contact.again_from, moment);
}

bool Contacts::may_reject(RobotId robot, Time now, Time period) {
  Contact& contact = at(robot);
  if (now < contact.next_reject_from) return false;
  contact.next_reject_from = now + period;
  return true;
}

bool can_communicate(const SharingSettings& sharing, const Contacts& contacts, Mode own, RobotId partner,
                     Mode partners, Time now) {
  if (now < sharing.starts || !may_pair(sharing.mode, own, partners)) return false;
  const Contact* contact = contacts.find(partner);
  return contact == nullptr || now >= contact->again_from;
}

Channel private_channel(RobotId one, RobotId other, std::uint32_t channel_count) {
  CARAVAN_ASSERT(channel_count >= 2);
  const std::uint64_t high = std::max(one, other).value;
  const std::uint64_t low = std::min(one, other).value;
  const std::uint64_t pair = high * (high - 1) / 2 + low;
  return Channel{static_cast<std::uint32_t>(1 + pair % (channel_count - 1))};
}

}  // namespace caravan::agent
