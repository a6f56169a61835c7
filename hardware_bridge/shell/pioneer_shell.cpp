// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/shell/pioneer_shell.hpp"

#include <spdlog/spdlog.h>

#include <array>
#include <utility>

#include "idl/stamp.hpp"
#include "runtime/process/run_process.hpp"

namespace caravan::bridge {
namespace msg = caravan_interfaces::msg;
using runtime::Discovery;
using runtime::ParticipantId;
using runtime::Watched;
using namespace std::chrono_literals;

namespace {

constexpr Time kRetry = 500ms;
constexpr auto kLastWords = 200ms;
// 9600 is what a Pioneer is delivered with.
constexpr std::array kBaudRates{9600U, 38400U, 19200U, 115200U, 57600U};

/// Sessions of later starts have higher numbers.
std::uint64_t new_session() {
  return static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
}

}  // namespace

PioneerShell::PioneerShell(const BridgeConfig& config, std::uint32_t robot, const Devices& devices,
                           const runtime::BusConfig& bus, runtime::Loop& loop)
    : devices_{devices},
      loop_{loop},
      began_{std::chrono::steady_clock::now()},
      session_{new_session()},
      bridge_{config},
      bus_{bus, [this](const Discovery& news) {
             if (news.kind == Discovery::Kind::kGone) mailbox_.post({news.participant, std::nullopt});
           }} {
  sensors_ = bus_.writer<msg::SensorFramePubSubType>(idl::kSensors, robot);
  bus_.reader<msg::RobotCommandPubSubType>(
      idl::kCommand, robot, [this](const msg::RobotCommand& command, const ParticipantId& sender) {
        mailbox_.post({sender, command});
      });
}

PioneerShell::~PioneerShell() { bus_.close(); }

void PioneerShell::read_mailbox() {
  for (const Mail& mail : mailbox_.take()) {
    if (!mail.command) {
      if (agent_ != mail.from) continue;
      spdlog::warn("the agent is gone: wheels stopped");
      agent_.reset();
      bridge_.forget_wish(now());
    } else if (mail.command->session() == session_) {
      if (!agent_) agent_ = mail.from;
      if (agent_ != mail.from) continue;  // one agent for one robot
      bridge_.wish({mail.command->left_mps(), mail.command->right_mps(), mail.command->gripper_closed()},
                   idl::to_time(mail.command->stamp()), now());
    }
  }
}

int PioneerShell::run() {
  for (;;) {
    keep_lines_open();
    bridge_.tick(now());
    carry_out();
    std::array<Watched, 2> watched{robot_.watched(), gps_.watched()};
    const auto woken = loop_.wait(began_ + bridge_.next_deadline(now()), watched);
    read_mailbox();
    attend_robot(watched[0].ready);
    attend_gps(watched[1].ready);
    carry_out();
    if (woken == runtime::Loop::Woken::kStop) {
      end();
      return runtime::kDone;
    }
  }
}

void PioneerShell::say(std::string& said, const std::string& text) {
  if (said == text) return;
  said = text;
  spdlog::warn("{}", text);
}

void PioneerShell::open_robot() {
  const unsigned baud = devices_.baud.value_or(kBaudRates[baud_]);
  retry_robot_ = now() + kRetry;
  const std::string wrong = robot_.open(devices_.robot, baud);
  if (!wrong.empty()) return say(said_robot_, to_text(devices_.robot) + ": " + wrong + ", trying again");
  if (!devices_.robot.path.empty()) spdlog::debug("trying {} baud", baud);
}

void PioneerShell::keep_lines_open() {
  if (!robot_.is_open() && now() >= retry_robot_) open_robot();
  if (robot_.is_up() && !robot_was_up_) {
    robot_was_up_ = true;
    bridge_.robot_up(now());
  }
  if (devices_.gps && !gps_.is_open() && now() >= retry_gps_) {
    retry_gps_ = now() + kRetry;
    const std::string wrong = gps_.open(*devices_.gps, devices_.gps_baud);
    if (!wrong.empty()) say(said_gps_, "GPS " + to_text(*devices_.gps) + ": " + wrong + ", trying again");
  }
}

void PioneerShell::attend_robot(bool ready) {
  if (ready) {
    const Bytes bytes = robot_.attend();
    if (!bytes.empty()) bridge_.robot_says(bytes, now());
  }
  if (robot_.is_open()) return;
  if (!robot_.failure().empty()) {
    say(said_robot_, to_text(devices_.robot) + ": " + robot_.failure() + ", trying again");
  }
  if (std::exchange(robot_was_up_, false)) bridge_.robot_down(now());
}

void PioneerShell::attend_gps(bool ready) {
  if (!ready) return;
  const Bytes bytes = gps_.attend();
  if (!bytes.empty()) {
    said_gps_.clear();
    bridge_.gps_says(bytes, now());
  }
  if (gps_.is_open()) return;
  say(said_gps_, "GPS " + to_text(*devices_.gps) + ": " + gps_.failure() + ", trying again");
  bridge_.gps_down();
}

void PioneerShell::carry_out() {
  const Bridge::Effects effects = bridge_.take_effects();
  robot_.write(effects.to_robot);
  for (const Notice& notice : effects.notices) {
    spdlog::log(notice.weight == Notice::Weight::kInfo ? spdlog::level::info : spdlog::level::warn, "{}",
                notice.text);
  }
  if (!effects.frames.empty()) said_robot_.clear();
  for (const Frame& frame : effects.frames) publish(frame);
  if (!effects.reopen_robot) return;
  baud_ = (baud_ + 1) % kBaudRates.size();
  robot_.close();
  robot_was_up_ = false;
  retry_robot_ = Time{0};
}

void PioneerShell::publish(const Frame& frame) {
  frame_.stamp(idl::to_wire(frame.stamp));
  frame_.session(session_);
  frame_.sonar_range_m(frame.sonar_range_m);
  frame_.sonar_age_s(frame.sonar_age_s);
  frame_.gps_x_m(frame.x_m);
  frame_.gps_y_m(frame.y_m);
  frame_.compass_yaw_rad(frame.yaw_rad);
  frame_.left_wheel_rad(frame.left_wheel_rad);
  frame_.right_wheel_rad(frame.right_wheel_rad);
  frame_.holding(frame.holding);
  frame_.radio_due(false);
  if (!sensors_.write(frame_) && refused_writes_++ == 0)
    spdlog::error("DDS refused a sample: the agent misses a frame");
}

void PioneerShell::end() {
  bridge_.close();
  carry_out();
  // The last words are short; a line that does not take them at once may never.
  const auto until = std::chrono::steady_clock::now() + kLastWords;
  while (robot_.is_up() && robot_.watched().for_writing && std::chrono::steady_clock::now() < until) {
    (void)robot_.attend();
  }
}

}  // namespace caravan::bridge
