// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/event_book.hpp"

#include <algorithm>

#include "experiment/metrics/csv_file.hpp"

namespace caravan::experiment {
namespace {

std::string seconds(Time time) { return fixed(in_seconds(time), 3); }

std::string to_text(const Exchange& exchange) {
  return "partner=" + std::to_string(exchange.partner) + " session=" + std::to_string(exchange.session) +
         " primary=" + (exchange.primary ? "true" : "false") +
         " completed=" + (exchange.completed ? "true" : "false") + " began_s=" + seconds(exchange.began) +
         " ended_s=" + seconds(exchange.ended);
}

void add_step(const Observation& observation, std::vector<EventRow>& rows) {
  for (const Contact& contact : observation.contacts) {
    rows.push_back({observation.stamp, contact.robot, "contact",
                    contact.other == 0 ? "with=static" : "with=" + std::to_string(contact.other)});
  }
  for (const ItemEvent& item : observation.item_events) {
    const bool delivery = item.kind == ItemEvent::Kind::kDelivery;
    rows.push_back({observation.stamp, item.robot, delivery ? "delivery" : "pick_up",
                    delivery ? "items=" + std::to_string(observation.items_delivered) : ""});
  }
}

}  // namespace

std::vector<EventRow> EventBook::observe(const Observation& observation) {
  std::vector<EventRow> rows;
  if (!observation.last) add_membership(observation, rows);
  add_step(observation, rows);
  for (const AgentReport& report : observation.agent_reports) {
    if (report.robot == 0 || report.robot > members_.size()) continue;
    for (const Exchange& exchange : report.exchanges)
      rows.push_back({observation.stamp, report.robot, "exchange", to_text(exchange)});
    for (const Event& own : report.events)
      rows.push_back({observation.stamp, report.robot, own.name, own.detail});
  }
  return rows;
}

void EventBook::add_membership(const Observation& observation, std::vector<EventRow>& rows) {
  for (std::uint32_t id = 1; id <= members_.size(); ++id) {
    const bool member = std::ranges::binary_search(observation.members, id);
    if (seen_members_ && member != members_[id - 1])
      rows.push_back({observation.stamp, id, member ? "joined" : "left", ""});
    members_[id - 1] = member;
  }
  seen_members_ = true;
}

}  // namespace caravan::experiment
