// SPDX-License-Identifier: Apache-2.0
#include "radio_emulator/medium/medium.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/pure/random.hpp"

namespace caravan::radio {
namespace {

/// A station that takes part: it has a position and a transmission.
struct Radio {
  const Station* station;
  const Transmission* transmission;
};

/// Pointers to the first element of each robot, sorted by robot.
template <typename Item>
std::vector<const Item*> by_robot(std::span<const Item> items) {
  std::vector<const Item*> sorted;
  sorted.reserve(items.size());
  for (const Item& item : items) sorted.push_back(&item);
  const auto lower = [](const Item* a, const Item* b) { return a->robot < b->robot; };
  const auto same = [](const Item* a, const Item* b) { return a->robot == b->robot; };
  std::stable_sort(sorted.begin(), sorted.end(), lower);
  sorted.erase(std::unique(sorted.begin(), sorted.end(), same), sorted.end());
  return sorted;
}

std::vector<Radio> radios_by_robot(std::span<const Station> stations,
                                   std::span<const Transmission> transmissions) {
  const std::vector<const Station*> places = by_robot(stations);
  const std::vector<const Transmission*> senders = by_robot(transmissions);
  std::vector<Radio> radios;
  radios.reserve(std::min(places.size(), senders.size()));
  auto sender = senders.begin();
  for (const Station* place : places) {
    while (sender != senders.end() && (*sender)->robot < place->robot) ++sender;
    if (sender != senders.end() && (*sender)->robot == place->robot) radios.push_back({place, *sender});
  }
  return radios;
}

/// The medium during one step.
class Air {
 public:
  Air(const MediumConfig& config, std::uint64_t step, std::vector<Radio> radios,
      std::span<const LinkRule> rules, Drops& drops)
      : config_{config}, step_{step}, radios_{std::move(radios)}, rules_{rules}, drops_{drops} {
    receptions_.reserve(radios_.size());
    for (const Radio& radio : radios_) receptions_.push_back({radio.station->robot, {}});
    for (std::size_t index = 0; index < radios_.size(); ++index) {
      const Station& station = *radios_[index].station;
      if (std::isfinite(station.x_m) && std::isfinite(station.y_m)) west_to_east_.push_back(index);
    }
    std::sort(west_to_east_.begin(), west_to_east_.end(), [this](std::size_t a, std::size_t b) {
      const double x_a = radios_[a].station->x_m;
      const double x_b = radios_[b].station->x_m;
      return x_a != x_b ? x_a < x_b : a < b;
    });
    rank_.assign(radios_.size(), radios_.size());
    for (std::size_t rank = 0; rank < west_to_east_.size(); ++rank) rank_[west_to_east_[rank]] = rank;
  }

  std::vector<Reception> carry() {
    for (std::size_t sender = 0; sender < radios_.size(); ++sender) send(sender);
    std::erase_if(receptions_, [](const Reception& reception) { return reception.frames.empty(); });
    return std::move(receptions_);
  }

 private:
  struct Neighbour {
    std::size_t index;  // in radios_
    Link link;
  };

  /// Call it in ascending order of sender ids; each queue fills in that order.
  void send(std::size_t sender) {
    find_neighbours(sender);
    const Transmission& transmission = *radios_[sender].transmission;
    for (std::size_t index = 0; index < transmission.frames.size(); ++index) {
      const Frame& frame = transmission.frames[index];
      if (frame.bytes.size() > config_.mtu_bytes) {
        ++drops_.over_mtu;
      } else if (frame.channel >= config_.channel_count) {
        ++drops_.bad_channel;
      } else {
        for (const Neighbour& receiver : neighbours_) offer(frame, index, sender, receiver);
      }
    }
  }

  void offer(const Frame& frame, std::size_t index, std::size_t sender, const Neighbour& receiver) {
    const Radio& radio = radios_[receiver.index];
    if (radio.transmission->tuned != frame.channel) return;
    Reception& reception = receptions_[receiver.index];
    if (is_lost(*radios_[sender].station, *radio.station, receiver.link, index)) {
      ++drops_.lost;
    } else if (reception.frames.size() >= config_.queue_length) {
      ++drops_.queue_full;
    } else {
      reception.frames.push_back({frame.channel, frame.bytes, receiver.link.signal_strength_dbm});
    }
  }

  [[nodiscard]] bool is_lost(const Station& sender, const Station& receiver, const Link& link,
                             std::size_t index) const {
    const double loss = loss_on(rules_, sender, receiver).value_or(link.loss_probability);
    if (loss <= 0.0) return false;
    const std::uint64_t word = pure::mix_all(config_.seed, step_, sender.robot, receiver.robot, index);
    return pure::unit_interval(word) < loss;
  }

  /// Searches from the sender's rank to the east and to the west until the distance in x alone exceeds the
  /// range. Compares squares, as the range rule does, so that rounding cannot make the two disagree.
  void find_neighbours(std::size_t sender) {
    neighbours_.clear();
    const std::size_t rank = rank_[sender];
    if (rank == radios_.size()) return;
    for (std::size_t east = rank + 1; east < west_to_east_.size(); ++east) {
      if (!take_if_near(sender, west_to_east_[east])) break;
    }
    for (std::size_t west = rank; west > 0; --west) {
      if (!take_if_near(sender, west_to_east_[west - 1])) break;
    }
  }

  /// False when `other` and all beyond it are out of range in x.
  bool take_if_near(std::size_t sender, std::size_t other) {
    const double dx = radios_[other].station->x_m - radios_[sender].station->x_m;
    const double dy = radios_[other].station->y_m - radios_[sender].station->y_m;
    if (const auto link = propagate(config_.propagation, dx * dx + dy * dy)) {
      neighbours_.push_back({other, *link});
    }
    const double range_m = greatest_range_m(config_.propagation);
    return dx * dx <= range_m * range_m;
  }

  const MediumConfig& config_;
  std::uint64_t step_;
  std::vector<Radio> radios_;  // by robot
  std::span<const LinkRule> rules_;
  std::vector<std::size_t> west_to_east_;  // indices of radios_ by x; those without a position are missing
  std::vector<std::size_t> rank_;          // of each radio in west_to_east_; radios_.size(): missing
  std::vector<Neighbour> neighbours_;      // of the current sender
  std::vector<Reception> receptions_;      // by robot
  Drops& drops_;
};

}  // namespace

std::vector<Reception> deliver(const MediumConfig& config, std::uint64_t step,
                               std::span<const Station> stations, std::span<const Transmission> transmissions,
                               Drops& drops, std::span<const LinkRule> rules) {
  return Air{config, step, radios_by_robot(stations, transmissions), rules, drops}.carry();
}

}  // namespace caravan::radio
