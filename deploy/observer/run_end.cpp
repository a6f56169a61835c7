// SPDX-License-Identifier: Apache-2.0
#include "deploy/observer/run_end.hpp"

#include <algorithm>

namespace caravan::deploy {
namespace msg = caravan_interfaces::msg;

experiment::RunEnd run_end(const std::optional<msg::WorldStatus>& world,
                           const std::optional<msg::RadioStatus>& radio, double agents_compute_s) {
  experiment::RunEnd end;
  if (!world) return end;
  end.digest = world->digest();
  end.disturbed = world->disturbed();
  end.wall_time_s = world->wall_s();
  end.refusals.commands_refused = world->refused_commands();
  end.refusals.commands_clamped = world->clamped_commands();
  experiment::TimeSplit& split = end.time_split;
  split.physics_s = world->physics_s();
  split.sensors_s = world->sensors_s();
  split.agents_s = agents_compute_s;
  if (radio) {
    split.radio_s = radio->compute_s();
    end.refusals.frames_over_mtu = radio->over_mtu();
    end.refusals.frames_on_bad_channel = radio->bad_channel();
    end.refusals.frames_lost = radio->lost();
    end.refusals.frames_queue_full = radio->queue_full();
  }
  split.transport_s =
      std::max(0.0, end.wall_time_s - split.physics_s - split.sensors_s - split.radio_s - split.agents_s);
  return end;
}

}  // namespace caravan::deploy
