// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "hardware_bridge/core/arcos/command.hpp"
#include "hardware_bridge/core/arcos/settings.hpp"
#include "hardware_bridge/core/arcos/sip.hpp"
#include "hardware_bridge/core/host/line_lag.hpp"
#include "hardware_bridge/core/host/notice.hpp"
#include "hardware_bridge/core/values.hpp"
#include "runtime/pure/robot_model.hpp"

namespace caravan::bridge {

struct LinkConfig {
  double acceleration_mps2 = 2.0;  ///< set in the robot, for acceleration and deceleration
  double speed_limit_mps = robot_model::kWheelLimit_mps;
  double track_m = robot_model::kTrack_m;
  Time silence = std::chrono::milliseconds{400};  ///< without a SIP for this long the robot counts as silent
  /// Warns of a robot with a slower watchdog: nothing else stops it when its cable is cut.
  Time slowest_watchdog = std::chrono::milliseconds{600};
};

/// The host's end of an ARCOS connection. The caller opens, reads and writes the line.
///
///   state          | bytes                                     | time
///   ---------------+-------------------------------------------+---------------------------------------------
///   Down           | -                                         | -
///   Synchronising  | awaited SYNC echo: next; after the third  | 0.4 s: from SYNC0 again; the third time
///                  | OPEN and set-up: Opening                  | reopen the line (next baud rate)
///                  | SIP of an open connection: CLOSE, again   |
///   Opening        | SIP: Checking                             | 1 s: Synchronising
///   Checking       | CONFIG agrees with SYNC2: Running         | CONFIG requested every 0.5 s; the sixth
///                  | CONFIG differs: CLOSE, Synchronising      | time Running unchecked; silence 2 s: reopen
///   Running        | SIP: returned                             | PULSE every 0.5 s, CONFIG requested every
///                  |                                           | 1 s, at once when SIPs seem late;
///                  |                                           | silence 2 s: reopen
///
/// "-": ignored by design. Each wait has a deadline. A robot that stops answering CONFIG does not receive; a
/// robot whose SIPs arrive more slowly than it sends them is behind (LineLag).
class RobotLink {
 public:
  explicit RobotLink(const LinkConfig& config) : config_{config} {}

  /// The line is up; starts the handshake.
  void up(Time now);
  /// The line is down.
  void down();
  /// @return the SIPs in the bytes, once the connection is open
  [[nodiscard]] std::vector<arcos::Sip> receive(std::span<const std::uint8_t> bytes, Time now);
  void tick(Time now);
  /// Next deadline of tick(); none while the line is down.
  [[nodiscard]] std::optional<Time> next_deadline() const;

  /// Queues a packet for the robot if Running; ignored otherwise.
  void send(std::span<const std::uint8_t> packet);
  /// Stops the wheels with the emergency stop: maximum deceleration. The connection stays open.
  void brake();
  /// Stops the wheels with the set deceleration.
  void stop();
  /// Stops the wheels and closes the connection, at the end of the program.
  void close();
  void enable_motors() { send(arcos::encode(arcos::Order::kEnable, 1)); }

  /// Whether to leave the motors off when a connection is opened.
  void keep_motors_off(bool off) { motors_off_ = off; }

  [[nodiscard]] bool is_running() const { return std::holds_alternative<Running>(state_); }
  /// True while Running and within LinkConfig::silence after the last SIP.
  [[nodiscard]] bool is_heard(Time now) const;
  /// Why a robot that is heard must not be driven; empty: it may be.
  [[nodiscard]] std::string unsafe(Time now) const;
  /// When the robot counts as silent if no further SIP arrives. @pre is_running()
  [[nodiscard]] Time silent_at() const { return std::get<Running>(state_).heard + config_.silence; }
  /// Names of the robot, known from the first connection on.
  [[nodiscard]] const std::optional<arcos::Names>& names() const { return names_; }

  /// The bytes to write; empties the queue.
  [[nodiscard]] arcos::Bytes take_output();
  /// Whether to close and reopen the line, at the next baud rate if it is serial; resets the request.
  [[nodiscard]] bool take_reopen();
  [[nodiscard]] std::vector<Notice> take_notices();

 private:
  struct Down {};
  struct Synchronising {
    unsigned step = 0;
    unsigned attempts = 0;
    Time deadline{0};
  };
  struct Opening {
    Time deadline{0};
  };
  struct Checking {
    Time heard{0};
    Time ask_due{0};
    unsigned asked = 0;
  };
  struct Running {
    Time heard{0};
    Time pulse_due{0};
    Time ask_due{0};
    bool answers = false;              ///< has answered CONFIG
    std::optional<Time> unanswered{};  ///< since when a CONFIG request is unanswered
    std::deque<Time> asked{};          ///< times of CONFIG requests whose answers may still arrive
    LineLag lag{};
    bool behind = false;
  };

  void synchronise(Time now, unsigned attempts);
  void hear_sync(Synchronising& state, const arcos::Bytes& data, Time now);
  void open(Time now);
  void hear_settings(const arcos::Settings& settings, Time now);
  void check(const arcos::Settings& settings, Time now);
  void run(Time now, bool answers);
  void tell_of_watchdog(const arcos::Settings& settings);
  void tick(Checking& state, Time now);
  void tick(Running& state, Time now);
  void note(Notice::Weight weight, std::string text) { notices_.push_back({weight, std::move(text)}); }
  void line_anew(const std::string& why);
  void put(const arcos::Bytes& packet) { output_.insert(output_.end(), packet.begin(), packet.end()); }
  void put(arcos::Order order) { put(arcos::encode(order)); }

  LinkConfig config_;
  std::variant<Down, Synchronising, Opening, Checking, Running> state_;
  arcos::PacketFinder packets_;
  std::uint64_t garbage_told_ = 0;
  std::uint64_t destroyed_ = 0;  // corrupted packets so far
  std::optional<arcos::Names> names_;
  unsigned disagreements_ = 0;  // of SYNC2 and CONFIG, in a row
  Time cycle_ = std::chrono::milliseconds{100};
  bool motors_off_ = false;
  arcos::Bytes output_;
  bool reopen_ = false;
  std::vector<Notice> notices_;
};

}  // namespace caravan::bridge
