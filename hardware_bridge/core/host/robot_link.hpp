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
  double acceleration_mps2 = 2.0;  ///< what the robot is told to take for starting and braking
  double speed_limit_mps = robot_model::kWheelLimit_mps;
  double track_m = robot_model::kTrack_m;
  Time silence = std::chrono::milliseconds{400};  ///< without a SIP for so long, the robot is silent
  /// A robot whose own watchdog is slower is told of: nothing else stops it when its cable is cut.
  Time slowest_watchdog = std::chrono::milliseconds{600};
};

/// The host's end of an ARCOS connection, over a line that somebody else opens, reads and writes.
///
///   state          | bytes                                     | time
///   ---------------+-------------------------------------------+---------------------------------------------
///   Down           | -                                         | -
///   Synchronising  | awaited SYNC echo: next; after the third  | 0.4 s: from SYNC0 again; the third time the
///                  | OPEN and set-up: Opening                  | line is to be opened anew (next baud rate)
///                  | SIP: an open connection, CLOSE and again  |
///   Opening        | SIP: Checking                             | 1 s: Synchronising
///   Checking       | CONFIG agrees with SYNC2: Running         | CONFIG asked every 0.5 s; the sixth time
///                  | it does not: CLOSE, Synchronising         | Running unchecked; silence 2 s: line anew
///   Running        | SIP: told                                 | PULSE every 0.5 s, CONFIG asked every 1 s,
///                  |                                           | at once when SIPs seem late; silence 2 s:
///                  |                                           | line anew
///
/// "-" is ignored on purpose. Each wait ends. A robot whose answers to CONFIG end does not receive what it is
/// told; one whose SIPs come more slowly than it sends them is behind.
class RobotLink {
 public:
  explicit RobotLink(const LinkConfig& config) : config_{config} {}

  /// The line is there. Handshake begins.
  void up(Time now);
  /// The line is gone.
  void down();
  /// @return the SIPs among the bytes, once the connection is open
  [[nodiscard]] std::vector<arcos::Sip> receive(std::span<const std::uint8_t> bytes, Time now);
  void tick(Time now);
  /// When tick() has something to do; none while the line is down.
  [[nodiscard]] std::optional<Time> next_deadline() const;

  /// To be written to the robot, while Running; ignored otherwise.
  void send(std::span<const std::uint8_t> packet);
  /// Wheels at zero, the connection stays. Something is wrong: they brake as hard as they can.
  void brake();
  /// Wheels at zero, by their deceleration.
  void stop();
  /// Wheels at zero and the connection closed: the program ends.
  void close();
  void enable_motors() { send(arcos::encode(arcos::Order::kEnable, 1)); }

  /// Whether motors are switched on when a connection is opened.
  void keep_motors_off(bool off) { motors_off_ = off; }

  [[nodiscard]] bool is_running() const { return std::holds_alternative<Running>(state_); }
  /// Running, and heard of within the silence.
  [[nodiscard]] bool is_heard(Time now) const;
  /// Why a robot that is heard is not to be driven; empty: it may be.
  [[nodiscard]] std::string unsafe(Time now) const;
  /// When silence begins if nothing is heard until then. @pre is_running()
  [[nodiscard]] Time silent_at() const { return std::get<Running>(state_).heard + config_.silence; }
  /// Of the robot at the other end; set from the first time it was reached.
  [[nodiscard]] const std::optional<arcos::Names>& names() const { return names_; }

  /// What is to be written, once.
  [[nodiscard]] arcos::Bytes take_output();
  /// Is the line to be closed and opened again, with the next baud rate where it has one? Once.
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
    bool answers = false;              ///< it has answered CONFIG
    std::optional<Time> unanswered{};  ///< since when CONFIG is
    std::deque<Time> asked{};          ///< when CONFIG was, of answers that may still come
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
  std::uint64_t destroyed_ = 0;  // packets, so far
  std::optional<arcos::Names> names_;
  unsigned disagreements_ = 0;  // of SYNC2 and CONFIG, one after the other
  Time cycle_ = std::chrono::milliseconds{100};
  bool motors_off_ = false;
  arcos::Bytes output_;
  bool reopen_ = false;
  std::vector<Notice> notices_;
};

}  // namespace caravan::bridge
