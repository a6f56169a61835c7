// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/strangers.hpp"

#include <spdlog/spdlog.h>

#include <numeric>

namespace caravan::runtime {
namespace {

constexpr std::size_t kMostStrangers = 32;
constexpr std::size_t kMostTopics = 16;  // per participant

const char* to_text(Refusal why) {
  switch (why) {
    case Refusal::kMalformed:
      return "its bytes are not of the topic's type";
    case Refusal::kTooLong:
      return "it is longer than any valid sample";
    case Refusal::kNotItsRole:
      return "its writer states no role that may write this topic";
    case Refusal::kRoleIsHeld:
      return "another participant came first and holds the role";
  }
  return "";
}

}  // namespace

void Strangers::refuse(const ParticipantId& id, const Identity& identity, const std::string& topic,
                       Refusal why) {
  const std::lock_guard lock{mutex_};
  auto found = entries_.find(id);
  if (found == entries_.end() && entries_.size() < kMostStrangers) {
    found = entries_.emplace(id, Entry{{to_text(id, identity), {}, 0}, {}}).first;
  }
  Entry& entry = found == entries_.end() ? others_ : found->second;
  if (entry.stranger.who.empty()) entry.stranger.who = "further participants";
  ++entry.stranger.refused;
  if (entry.stranger.topics.size() < kMostTopics) entry.stranger.topics.insert(topic);
  if (!entry.told.insert(why).second) return;
  spdlog::warn("sample refused topic={}: {}; from {} (further ones are counted)", topic, to_text(why),
               entry.stranger.who);
}

void Strangers::forgive(const ParticipantId& id) {
  const std::lock_guard lock{mutex_};
  entries_.erase(id);
}

std::vector<Stranger> Strangers::all() const {
  const std::lock_guard lock{mutex_};
  std::vector<Stranger> strangers;
  for (const auto& [id, entry] : entries_) strangers.push_back(entry.stranger);
  if (others_.stranger.refused > 0) strangers.push_back(others_.stranger);
  return strangers;
}

std::string to_text(const Stranger& stranger) {
  const std::string topics = std::accumulate(stranger.topics.begin(), stranger.topics.end(), std::string{},
                                             [](const std::string& text, const std::string& topic) {
                                               return text + (text.empty() ? "" : ", ") + topic;
                                             });
  return stranger.who + ": " + std::to_string(stranger.refused) + " samples refused on " + topics;
}

}  // namespace caravan::runtime
