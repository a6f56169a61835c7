// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/config/tables.hpp"

namespace caravan::agent {
namespace {

void read_wait(TomlTable table, WaitSettings& wait) {
  table.read("stray_m", wait.stray_m, kDistance_m);
  table.read("stray_rad", wait.stray_rad, kTolerance_rad);
  read_time(table, "stray_pause_s", wait.stray_pause);
  read_time(table, "remembered_away_s", wait.remembered_away);
  table.refuse_unknown();
}

void read_sharing(TomlTable table, SharingSettings& sharing) {
  constexpr double kSessionSlot_s = 0.1;  // as kSessionSlot: two attempts of a pair need different numbers
  read_time(table, "silence_s", sharing.silence, 0.001);
  read_time(table, "linger_s", sharing.linger);
  read_time(table, "rest_s", sharing.rest, kSessionSlot_s);
  read_time(table, "hold_s", sharing.hold);
  read_time(table, "reject_period_s", sharing.reject_period);
  table.read("merge_gain_m", sharing.merge_gain_m, kDistance_m);
  table.refuse_unknown();
}

}  // namespace

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
  read_wait(algorithm.table("wait"), config.wait);
  read_sharing(algorithm.table("sharing"), sharing);
}

}  // namespace caravan::agent
