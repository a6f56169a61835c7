// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "deploy/kit/tally.hpp"

namespace caravan::deploy {

/// What an observer knows of one robot in this session.
struct SeenRobot {
  bool has_reported = false;  ///< what it says of itself is known
  std::string mode = {};      ///< explore, transport
  std::string activity = {};  ///< idle, driving, avoiding, exchanging
  std::string origin = {};    ///< of its path: none, found, received
  std::uint32_t trips = 0;
  std::uint32_t exchanges = 0;  ///< completed
  std::uint32_t failed_exchanges = 0;
  bool is_member = false;  ///< of the newest step
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;
  std::optional<std::string> sent = {};  ///< frames of its newest step, if they are overheard
};

/// What an observer knows of one process of its own.
struct SeenProcess {
  std::string state;             ///< running, suspended, ended
  std::optional<int> exit_code;  ///< 128 + n when signal n ended it
  std::string log;               ///< the file
  pid_t pid = 0;
};

/// All that an observer of a deployment knows at one moment: what expectations are about. A plain value, but
/// for the tally, which goes on.
struct Seen {
  std::string state = "absent";  ///< of the world: absent, waiting, running, paused, finished
  std::uint64_t session = 0;     ///< of the newest world that was heard
  std::uint32_t sessions = 0;    ///< so many worlds were heard
  std::uint64_t step = 0;        ///< the newest that has begun; of a paused world the one that begins next
  double time_s = 0.0;           ///< simulated
  std::uint32_t items = 0;       ///< delivered
  std::uint32_t members = 0;
  bool disturbed = false;
  std::string digest;  ///< empty until the run has ended
  std::vector<std::string> missing;
  std::vector<std::string> hung;
  std::vector<std::string> gone;
  std::vector<std::string> removed;
  std::uint64_t refused_commands = 0;
  bool radio_is_heard = false;
  std::uint64_t deliveries = 0;  ///< frames that the radio has handed over
  std::uint64_t lost_frames = 0;
  std::map<std::uint32_t, SeenRobot> robots;
  std::map<std::string, SeenProcess> processes;  ///< by name: world, radio, robot 3
  std::deque<std::string> events;                ///< the newest few, in words
  std::shared_ptr<const Tally> tally;            ///< of this session; null: no world was heard
};

}  // namespace caravan::deploy
