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

namespace caravan::deploy {

class Tally;

/// An observer's knowledge of one robot in this session.
struct SeenRobot {
  bool has_reported = false;  ///< its own report is known
  std::string mode = {};      ///< explore, transport
  std::string activity = {};  ///< idle, driving, avoiding, exchanging
  std::string origin = {};    ///< of its path: none, found, received
  std::uint32_t trips = 0;
  std::uint32_t exchanges = 0;  ///< completed
  std::uint32_t failed_exchanges = 0;
  bool is_member = false;  ///< of the latest step
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;
  std::optional<std::string> sent = {};  ///< frames of its latest step, if they are received here
};

/// The state of one of the deployment's own processes.
struct SeenProcess {
  std::string state;             ///< running, suspended, ended
  std::optional<int> exit_code;  ///< 128 + n when signal n ended it
  std::string log;               ///< path of the log
  pid_t pid = 0;
};

/// The state of a deployment at one moment, as known to an observer; expectations refer to it. A plain value,
/// except for the tally, which is updated.
struct Seen {
  std::string state = "absent";  ///< of the world: absent, waiting, running, paused, finished
  std::uint64_t session = 0;     ///< of the latest world
  std::uint32_t sessions = 0;    ///< number of world sessions seen
  std::uint64_t step = 0;        ///< the latest step that has begun; of a paused world the next step
  double time_s = 0.0;           ///< simulated time
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
  std::uint64_t deliveries = 0;  ///< frames that the radio delivered
  std::uint64_t lost_frames = 0;
  std::map<std::uint32_t, SeenRobot> robots;
  std::map<std::string, SeenProcess> processes;  ///< by name: world, radio, robot 3
  std::deque<std::string> events;                ///< the latest few, as text
  std::shared_ptr<const Tally> tally;            ///< for `metric` and `event` of this session
};

}  // namespace caravan::deploy
