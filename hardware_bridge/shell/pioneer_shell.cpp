// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/shell/pioneer_shell.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <utility>

#include "idl/stamp.hpp"
#include "runtime/config/start_error.hpp"
#include "runtime/process/run_process.hpp"

namespace caravan::bridge {
namespace msg = caravan_interfaces::msg;
using runtime::Discovery;
using runtime::Polled;
using runtime::Sender;
using runtime::Tenure;
using namespace std::chrono_literals;

namespace {

constexpr auto kLastWords = 200ms;
constexpr unsigned kBriefWorthTelling = 3;

void log(const Notice& notice) {
  spdlog::log(notice.weight == Notice::Weight::kInfo ? spdlog::level::info : spdlog::level::warn, "{}",
              notice.text);
}

/// Later starts have higher session numbers.
std::uint64_t new_session() {
  return static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
}

}  // namespace

PioneerShell::PioneerShell(const BridgeConfig& config, std::uint32_t robot, const Devices& devices,
                           const runtime::BusConfig& bus, runtime::Loop& loop)
    : baud_{devices.baud},
      gps_baud_{devices.gps_baud},
      loop_{loop},
      began_{std::chrono::steady_clock::now()},
      session_{new_session()},
      number_{robot},
      bridge_{config},
      robot_{devices.robot, "", "--port"},
      bus_{bus, [this](const Discovery& news) { mailbox_.post(news); }},
      sole_{bus_, bus.lease_s, idl::kSensors, robot} {
  if (devices.gps) gps_.emplace(*devices.gps, "GPS ", "--gps");
  sensors_ = bus_.writer<msg::SensorFramePubSubType>(idl::kSensors, robot);
  bus_.reader<msg::RobotCommandPubSubType>(idl::kCommand, robot,
                                           [this](const msg::RobotCommand& command, const Sender& sender) {
                                             mailbox_.post(Command{sender, command});
                                           });
}

PioneerShell::~PioneerShell() { bus_.close(); }

void PioneerShell::read_mailbox() {
  for (const Mail& mail : mailbox_.take()) {
    std::visit([this](const auto& one) { read(one); }, mail);
  }
}

void PioneerShell::read(const Discovery& news) {
  sole_.see(news, agent_.holder().has_value());
  const bool has_left =
      news.kind == Discovery::Kind::kGone ||
      (news.kind == Discovery::Kind::kWriterGone && news.topic == idl::name_for(idl::kCommand, number_));
  if (!has_left || !agent_.release(news.participant)) return;
  warn("the agent is gone: wheels stopped");
  bridge_.forget_wish(now());
  for (const Tenure::Later& take : agent_.hand_over()) take();
  if (const auto holder = agent_.holder()) bus_.forgive(*holder);
}

void PioneerShell::read(const Command& command) {
  if (command.sample.session() != session_) return;
  if (agent_.claim(command.from) != Tenure::Standing::kRefused) return obey(command.sample);
  bus_.refuse(command.from, idl::kCommand, number_);
  agent_.keep(command.from, [this, sample = command.sample] { obey(sample); });
}

void PioneerShell::obey(const msg::RobotCommand& command) {
  bridge_.wish({command.left_mps(), command.right_mps(), command.gripper_closed()},
               idl::to_time(command.stamp()), now());
}

int PioneerShell::run() {
  for (;;) {
    keep_lines_open();
    bridge_.tick(now());
    carry_out();
    std::array<Polled, 2> watched{robot_.line.watched(), gps_ ? gps_->line.watched() : Polled{}};
    const auto woken = loop_.wait(next_deadline(), watched);
    read_mailbox();
    if (const std::string lost = sole_.lost(); !lost.empty()) refuse(lost);
    attend_robot(watched[0].ready);
    attend_gps(watched[1].ready);
    carry_out();
    if (woken == runtime::Loop::Woken::kStop) {
      end();
      return runtime::kDone;
    }
  }
}

runtime::WallTime PioneerShell::next_deadline() const {
  Wall next = began_ + bridge_.next_deadline(now());
  if (const auto due = sole_.next_deadline()) next = std::min(next, *due);
  for (const Port* port : {&robot_, gps_ ? &*gps_ : nullptr}) {
    if (port == nullptr) continue;
    if (!port->line.is_open()) next = std::min(next, began_ + port->retry.due());
    if (const auto due = port->line.next_deadline()) next = std::min(next, *due);
  }
  return next;
}

void PioneerShell::tell(Notice notice) {
  if (const auto passed = limit_.pass(std::move(notice), now())) log(*passed);
}

void PioneerShell::open(Port& port, unsigned baud) {
  port.retry.tries(now());
  const std::string wrong = port.line.open(port.endpoint, baud);
  if (!port.line.unfit().empty() && !port.was_ours) refuse(port.name + ": " + port.line.unfit());
  port.opened = wrong.empty();
  port.was_ours = port.was_ours || port.opened;
  if (!wrong.empty()) warn(port.name + ": " + wrong + ", trying again");
}

void PioneerShell::keep_lines_open() {
  if (!robot_.line.is_open() && now() >= robot_.retry.due()) {
    const unsigned baud = baud_.value_or(search_.rate());
    open(robot_, baud);
    if (robot_.line.is_up()) spdlog::debug("trying {} baud", baud);
  }
  if (robot_.line.is_up() && !robot_was_up_) {
    robot_was_up_ = true;
    bridge_.robot_up(now());
  }
  if (gps_ && !gps_->line.is_open() && now() >= gps_->retry.due()) open(*gps_, gps_baud_);
}

Bytes PioneerShell::attend(Port& port, bool ready) {
  Bytes bytes;
  if (ready) bytes = port.line.attend();
  port.line.expire(std::chrono::steady_clock::now());
  if (port.line.is_up()) port.retry.up(now());
  if (port.line.is_open() || !std::exchange(port.opened, false)) return bytes;
  port.retry.down(now(), port.line.is_closed_by_other_end());
  const bool taken = port.retry.brief() >= kBriefWorthTelling;
  warn(port.name + ": " + port.line.failure() +
       (taken ? " again and again: another host may have it, or the device is not ready" : "") +
       ", trying again");
  return bytes;
}

void PioneerShell::attend_robot(bool ready) {
  const Bytes bytes = attend(robot_, ready);
  if (!bytes.empty()) bridge_.robot_says(bytes, now());
  if (!robot_.line.is_open() && std::exchange(robot_was_up_, false)) bridge_.robot_down(now());
}

void PioneerShell::attend_gps(bool ready) {
  if (!gps_) return;
  const Bytes bytes = attend(*gps_, ready);
  if (!bytes.empty()) bridge_.gps_says(bytes, now());
  if (!gps_->line.is_open()) bridge_.gps_down();
}

void PioneerShell::carry_out() {
  Bridge::Effects effects = bridge_.take_effects();
  robot_.line.write(effects.to_robot);
  for (Notice& notice : effects.notices) tell(std::move(notice));
  if (!effects.unfit.empty()) refuse(robot_.name + ": " + effects.unfit);
  for (const Notice& notice : limit_.take_due(now())) log(notice);
  if (!effects.frames.empty()) search_.found();
  for (const Frame& frame : effects.frames) publish(frame);
  if (!effects.reopen_robot) return;
  search_.next();
  robot_.line.close();
  robot_.opened = false;
  robot_was_up_ = false;
  robot_.retry.again();
}

void PioneerShell::publish(const Frame& frame) {
  if (sole_.must_be_silent()) return;
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

void PioneerShell::refuse(const std::string& why) {
  end();
  throw runtime::StartError{why};
}

void PioneerShell::end() {
  bridge_.close();
  carry_out();
  // The final packets are short: a line that does not accept them soon may never do so.
  const auto until = std::chrono::steady_clock::now() + kLastWords;
  Line& line = robot_.line;
  while (line.is_up() && line.watched().for_writing && std::chrono::steady_clock::now() < until) {
    (void)line.attend();
  }
}

}  // namespace caravan::bridge
