// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/config/tables.hpp"

namespace caravan::agent {

void read_radio_side(TomlTable& algorithm, Config& config) {
  SharingSettings& sharing = config.sharing;
  auto mode = static_cast<std::size_t>(sharing.mode);
  algorithm.read_choice("mode", mode, {"none", "partial", "full"});
  sharing.mode = static_cast<Sharing>(mode);
  algorithm.read("stop_to_exchange", sharing.stop_to_exchange);
  read_time(algorithm, "sharing_starts_s", sharing.starts);
  read_time(algorithm, "recontact_after_s", sharing.recontact_after);
  read_time(algorithm, "accept_period_s", sharing.accept_period, 0.001);
  algorithm.read("accept_attempts", sharing.accept_attempts, {1, 1000});
  read_time(algorithm, "session_timer_s", sharing.session_timer, 0.001);
  algorithm.read("points_per_frame", sharing.points_per_frame, {1, 65535});
  read_time(algorithm, "wait_period_s", config.wait.period);
  algorithm.read("wait_tells_place", config.wait.tells_place);
}

}  // namespace caravan::agent
